"""The honest comparison: what the textbook forms and SciPy lose, and what each costs."""
