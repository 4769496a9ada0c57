"""Types of the compiled module: every ufunc is one of three shapes."""

# A class may derive from both float32 and float64, says mypy of overlapping overloads; none does.
# mypy: disable-error-code="overload-overlap"

from typing import Any, Final, Literal, Protocol, TypedDict, TypeVar, Unpack, overload

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

_Number = float | np.float64 | np.int64 | np.int32
_F32 = NDArray[np.float32]
_F64 = NDArray[np.float64]
_Ints = NDArray[np.integer[Any]]
_Output = TypeVar("_Output", bound=np.ndarray[Any, Any])

class _HandlesUfuncs(Protocol):
    """Series, DataArray, Dask array and the like: they apply the ufunc and wrap the result."""

    def __array_ufunc__(self, ufunc: Any, method: Any, /, *inputs: Any, **kwargs: Any) -> Any: ...

_Wrapped = TypeVar("_Wrapped", bound=_HandlesUfuncs)

class _Options(TypedDict, total=False):
    where: ArrayLike
    casting: Literal["no", "equiv", "safe", "same_kind", "unsafe"]
    order: Literal["K", "A", "C", "F"]
    dtype: DTypeLike
    subok: bool
    signature: str | tuple[str, ...]

# NumPy marks `ufunc` final, yet gives its own ufuncs their types in this same way.
class _UnaryUfunc(np.ufunc):  # type: ignore[misc]
    @overload
    def __call__(self, x: ArrayLike, /, out: _Output, **options: Unpack[_Options]) -> _Output: ...
    @overload
    def __call__(self, x: _Number, /, out: None = None) -> np.float64: ...
    @overload
    def __call__(self, x: np.float32, /, out: None = None) -> np.float32: ...
    @overload
    def __call__(self, x: _F64, /, out: None = None) -> _F64: ...
    @overload
    def __call__(self, x: _F32, /, out: None = None) -> _F32: ...
    @overload
    def __call__(self, x: _Ints, /, out: None = None) -> NDArray[np.floating[Any]]: ...
    @overload
    def __call__(self, x: _Wrapped, /, out: None = None) -> _Wrapped: ...
    @overload
    def __call__(self, x: Any, /, out: Any = None, **options: Unpack[_Options]) -> Any: ...

class _BinaryUfunc(np.ufunc):  # type: ignore[misc]
    @overload
    def __call__(
        self, x1: ArrayLike, x2: ArrayLike, /, out: _Output, **options: Unpack[_Options]
    ) -> _Output: ...
    @overload
    def __call__(self, x1: _Number, x2: _Number, /, out: None = None) -> np.float64: ...
    @overload
    def __call__(
        self, x1: np.float32, x2: float | np.float32, /, out: None = None
    ) -> np.float32: ...
    @overload
    def __call__(
        self, x1: _F64, x2: _Number | _F64 | _F32 | _Ints, /, out: None = None
    ) -> _F64: ...
    @overload
    def __call__(self, x1: _Number | _F32 | _Ints, x2: _F64, /, out: None = None) -> _F64: ...
    @overload
    def __call__(self, x1: _F32, x2: float | np.float32 | _F32, /, out: None = None) -> _F32: ...
    @overload
    def __call__(self, x1: float | np.float32, x2: _F32, /, out: None = None) -> _F32: ...
    @overload
    def __call__(
        self, x1: _Wrapped, x2: float | np.ndarray[Any, Any], /, out: None = None
    ) -> _Wrapped: ...
    @overload
    def __call__(
        self, x1: Any, x2: Any, /, out: Any = None, **options: Unpack[_Options]
    ) -> Any: ...

class _TernaryUfunc(np.ufunc):  # type: ignore[misc]
    @overload
    def __call__(
        self,
        x1: ArrayLike,
        x2: ArrayLike,
        x3: ArrayLike,
        /,
        out: _Output,
        **options: Unpack[_Options],
    ) -> _Output: ...
    @overload
    def __call__(
        self, x1: _Number, x2: _Number, x3: _Number, /, out: None = None
    ) -> np.float64: ...
    @overload
    def __call__(
        self, x1: _F64, x2: _Number | _F64, x3: _Number | _F64, /, out: None = None
    ) -> _F64: ...
    @overload
    def __call__(
        self, x1: _Number | _F64, x2: _F64, x3: _Number | _F64, /, out: None = None
    ) -> _F64: ...
    @overload
    def __call__(
        self, x1: _Number | _F64, x2: _Number | _F64, x3: _F64, /, out: None = None
    ) -> _F64: ...
    @overload
    def __call__(
        self, x1: Any, x2: Any, x3: Any, /, out: Any = None, **options: Unpack[_Options]
    ) -> Any: ...

__version__: Final[str]

def isa() -> str: ...

lambertw0: Final[_UnaryUfunc]
lambertwm1: Final[_UnaryUfunc]
lambertw0_offset: Final[_UnaryUfunc]
lambertwm1_offset: Final[_UnaryUfunc]
tree: Final[_UnaryUfunc]
log1pmx: Final[_UnaryUfunc]
optimal_angle: Final[_UnaryUfunc]

apex_x: Final[_BinaryUfunc]
apex_y: Final[_BinaryUfunc]
apex_time: Final[_BinaryUfunc]
apex_distance: Final[_BinaryUfunc]
apex_elevation: Final[_BinaryUfunc]
apex_curvature: Final[_BinaryUfunc]
locus_launch_angle: Final[_BinaryUfunc]
locus_launch_angle_d1: Final[_BinaryUfunc]
locus_launch_angle_d2: Final[_BinaryUfunc]
locus_radius: Final[_BinaryUfunc]
locus_curvature: Final[_BinaryUfunc]
flight_time: Final[_BinaryUfunc]
flight_range: Final[_BinaryUfunc]
envelope_height: Final[_BinaryUfunc]

flight_x: Final[_TernaryUfunc]
flight_y: Final[_TernaryUfunc]
trajectory_height: Final[_TernaryUfunc]
aim_low: Final[_TernaryUfunc]
aim_high: Final[_TernaryUfunc]
