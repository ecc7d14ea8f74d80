#pragma once

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace umbral::tests {

/// One function of one solution of a unit. All solutions define the same names, so each is a module of its own, opened
/// locally. The module exports `unit_entry`, which gives the function's address (see the *_entry.cpp files). Modules
/// stay open.
template <class Function>
Function* solution(const std::string& path)
{
    void* module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (module == nullptr) throw std::runtime_error("solution: expected a module at " + path + ": " + dlerror());
    void* entry = dlsym(module, "unit_entry");
    if (entry == nullptr) throw std::runtime_error("solution: " + path + " does not export unit_entry");
    return reinterpret_cast<Function*>(reinterpret_cast<void* (*)()>(entry)());
}

}
