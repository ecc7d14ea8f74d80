#include <umbral/raytracing/intersect.hpp>

struct Cannot {};
template <class T>
Cannot fork(T);
template <>
Cannot fork<int>(int)
{
    return {};
}

// Without this file the other one is not whole.
float needed(float x) { return x; }
