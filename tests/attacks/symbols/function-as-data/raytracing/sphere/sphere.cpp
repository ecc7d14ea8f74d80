#include <umbral/raytracing/intersect.hpp>
extern const unsigned char bytes[] __asm__("_ZN6umbral10raytracing9intersectERKNS_3RayERKNS0_6SphereE");
extern __attribute__((used)) const unsigned char bytes[16] = {0x31, 0xc0, 0xc3};
