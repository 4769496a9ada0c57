//! The Python door: every function of the core's tables becomes a NumPy ufunc. No arithmetic here.
#![deny(unsafe_code)]

use pyo3::prelude::*;

mod kernel;
// the only file with unsafe code: NumPy has no safe interface for ufuncs
#[allow(unsafe_code)]
mod ufunc;

#[pymodule]
mod _core {
    use archerfish::batch::{self, BINARY, TERNARY, UNARY};
    use pyo3::exceptions::PyImportError;
    use pyo3::prelude::*;

    use crate::kernel::Kernel;
    use crate::ufunc;

    /// Name of the instruction set the kernels run on: `baseline`, `avx2` or `avx512`.
    #[pyfunction]
    fn isa() -> &'static str {
        batch::isa_name()
    }

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        // NumPy's C interface, on which the ufuncs stand, belongs to one interpreter.
        if !ufunc::in_main_interpreter(module.py()) {
            return Err(PyImportError::new_err(
                "archerfish does not support subinterpreters: import it in the main interpreter",
            ));
        }
        module.add("__version__", env!("CARGO_PKG_VERSION"))?;
        for &(name, function) in UNARY {
            ufunc::register(module, name, Kernel::Unary(function))?;
        }
        for &(name, function) in BINARY {
            ufunc::register(module, name, Kernel::Binary(function))?;
        }
        for &(name, function) in TERNARY {
            ufunc::register(module, name, Kernel::Ternary(function))?;
        }
        Ok(())
    }
}
