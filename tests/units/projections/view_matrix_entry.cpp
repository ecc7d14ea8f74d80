#include <umbral/projections/view.hpp>

extern "C" void* unit_entry() { return reinterpret_cast<void*>(&umbral::projections::view_matrix); }
