#pragma once

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace umbral::tests {

/// What the module of one solution of a unit exports. All solutions define the same names, so each is a module of its
/// own, opened locally. The module exports `unit_entry`, which gives the address of a function, or of a table of them
/// (see the *_entry.cpp files). Modules stay open.
inline void* unit_entry(const std::string& path)
{
    void* module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (module == nullptr) throw std::runtime_error("solution: expected a module at " + path + ": " + dlerror());
    void* entry = dlsym(module, "unit_entry");
    if (entry == nullptr) throw std::runtime_error("solution: " + path + " does not export unit_entry");
    return reinterpret_cast<void* (*)()>(entry)();
}

/// One function of one solution of a unit.
template <class Function>
Function* solution(const std::string& path)
{
    return reinterpret_cast<Function*>(unit_entry(path));
}

/// The table of functions of one solution of a unit.
template <class Table>
const Table* solution_table(const std::string& path)
{
    return static_cast<const Table*>(unit_entry(path));
}

}
