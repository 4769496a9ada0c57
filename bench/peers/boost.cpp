// Boost.Math's real Lambert W over arrays, for bench/peers.py.

#include <boost/math/special_functions/lambert_w.hpp>
#include <cstddef>

extern "C" void lambertw0(const double* z, double* out, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) out[i] = boost::math::lambert_w0(z[i]);
}

extern "C" void lambertwm1(const double* z, double* out, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) out[i] = boost::math::lambert_wm1(z[i]);
}
