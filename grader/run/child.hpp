#pragma once

#include "run/sandbox.hpp"

namespace umbral::grader {

/// What every run of a spawner shares; built once, before the first fork.
struct ChildSetup {
    sandbox::Filter filter;
    std::uint64_t base_address_space = 0;  ///< bytes the spawner maps: a run's memory limit comes on top
};

/// The life of a run, in a fresh fork of the spawner: takes its job from `run_socket`, opens its libraries, closes
/// everything else, enters the sandbox, says so to the grader by its socket and to the spawner by the eventfd
/// `confined`, reads the student's texts, loads the libraries, runs one case, writes the recording. Never returns, and
/// lets no exception out: those of static initialisers come through dlopen.
[[noreturn]] void live(const ChildSetup& setup, int run_socket, int confined) noexcept;

}
