#pragma once

namespace umbral {

/// How often this process has reached a stub; read by the run when its case is over.
[[nodiscard]] unsigned not_implemented_count() noexcept;

}
