#pragma once

#include "bench/judges/picture_pair.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// Runs every case of a unit that is judged by a picture, with the inputs of one seed: hands on what the mistakes and
/// the alternatives draw, what the reference draws where the oracle is expected, and through the other back end of
/// OpenGL (`other_gl`, a worker with it), and the expected picture under the operators on pixels. Mistakes that draw
/// nothing comparable are left out.
void visit_unit(Worker& worker, Worker& other_gl, const Exercise& exercise, unsigned seed, const VisitPair& visit);

}
