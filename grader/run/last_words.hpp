#pragma once

#include <umbral/record/wire.hpp>

/// What a run says about its own end: a signal, an uncaught exception, a refused system call, noted in the recording's
/// header.
namespace umbral::grader::last_words {

/// From here on crashes and refused calls are noted in `header`, which must stay mapped. Allocates; call it before the
/// sandbox.
void listen(wire::Header& header);

/// Frames at a crash are told relative to the library that holds `base`, if they lie in it.
void set_library(wire::Header& header, const void* handle);

/// Notes an exception that ended the case (or std::terminate); returns for the caller to exit.
void note_exception(wire::Header& header) noexcept;

}
