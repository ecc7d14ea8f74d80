#pragma once

#include <string>
#include <vector>

namespace umbral::grader::attack {

/// The user and group of that name, on every Linux.
inline constexpr unsigned nobody = 65534;

/// Under which rights and protections a class is graded.
struct Setting {
    bool as_nobody = false;           ///< as the user nobody; else as whoever runs this
    bool without_namespaces = false;  ///< as on machines that give no user namespaces
    std::string gl;                   ///< "osmesa", "egl"; empty: as Umbral chooses

    /// "root, no namespaces, egl"
    [[nodiscard]] std::string name() const;
};

/// All eight, in a fixed order; those of OSMesa first.
[[nodiscard]] std::vector<Setting> all_settings();

/// Why this setting cannot be made by this user; empty: it can.
[[nodiscard]] std::string why_not(const Setting& setting);

/// For a fresh child before exec: becomes nobody, and lets the kernel refuse user namespaces to it and all its
/// children. Changes nothing for other processes. Throws std::system_error.
void enter(const Setting& setting);

}
