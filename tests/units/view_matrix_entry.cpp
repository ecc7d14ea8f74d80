#include <umbral/projections/view.hpp>

extern "C" auto unit_entry() { return &umbral::projections::view_matrix; }
