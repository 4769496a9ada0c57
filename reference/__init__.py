"""Exact values of every public function, from definitions; see README.md beside this file."""
