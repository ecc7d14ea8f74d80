#include <umbral/raytracing/intersect.hpp>

extern "C" auto unit_entry() { return &umbral::raytracing::intersect; }
