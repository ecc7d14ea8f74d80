#include <umbral/raytracing/intersect.hpp>

struct Cannot {};
template <class T>
Cannot fork(T);
template <>
Cannot fork<int>(int)
{
    return {};
}
