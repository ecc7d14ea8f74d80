#include "solutions.hpp"

#include <dlfcn.h>

#include <stdexcept>

namespace umbral::bench {

Intersect* sphere_solution(const std::filesystem::path& units, const std::string& solution)
{
    const std::string path = units / "raytracing" / "sphere" / (solution + ".so");
    void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr)
        throw std::runtime_error("expected the " + solution + " of raytracing/sphere at " + path +
                                 "; is the project built? " + dlerror());
    // umbral::raytracing::intersect(umbral::Ray const&, umbral::raytracing::Sphere const&)
    void* const function = dlsym(library, "_ZN6umbral10raytracing9intersectERKNS_3RayERKNS0_6SphereE");
    if (function == nullptr)
        throw std::runtime_error(path + " does not define umbral::raytracing::intersect(const Ray&, const Sphere&)");
    return reinterpret_cast<Intersect*>(function);
}

}
