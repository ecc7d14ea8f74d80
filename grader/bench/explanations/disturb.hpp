#pragma once

#include <span>
#include <umbral/core/random.hpp>
#include <umbral/record/tensor.hpp>

namespace umbral::grader {

/// A way to spoil right results of which no sentence tells the reason.
struct Disturbance {
    const char* name;
    /// The tensor spoilt; equal to the given one where the disturbance does not apply to it.
    Tensor (*apply)(const Tensor& right, Random& random);
};

/// Rows replaced, noise, a part lost, rows mixed, values bent, pictures smeared, jittered and speckled.
[[nodiscard]] std::span<const Disturbance> disturbances();

/// The same result rounded otherwise, as another compiler or another order of terms would give it: a third of the
/// floats one ulp up, a third one down; every tenth byte one level up or down. Texts and whole numbers stay.
[[nodiscard]] Tensor rounded_otherwise(const Tensor& tensor, Random& random);

}
