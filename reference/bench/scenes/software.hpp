#pragma once

#include "drafting.hpp"
#include "model.hpp"
#include "operators.hpp"
#include "tracing.hpp"

namespace umbral::bench::scenes {

/// The software painters, as one compiler made them.
struct SoftwareBuild {
    /// Draws a model. Throws std::invalid_argument for lines.
    Image (*paint)(const Model&, Flaw, Way);
    Image (*draft)(const Drawing&, Flaw, Way);
    Image (*trace)(const Traced&, Flaw, Way);
};

// The same files, compiled in several ways (CMakeLists.txt).
namespace plain {
[[nodiscard]] SoftwareBuild build();
}
namespace not_optimised {
[[nodiscard]] SoftwareBuild build();
}
namespace fused {
[[nodiscard]] SoftwareBuild build();
}
namespace in_double {
[[nodiscard]] SoftwareBuild build();
}
namespace other_compiler {
[[nodiscard]] SoftwareBuild build();
}

}
