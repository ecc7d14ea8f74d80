#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <system_error>
#include <thread>

namespace umbral::test {

/// Removes a folder in which what a killed run has started may write for a moment still.
inline void remove_at_last(const std::filesystem::path& folder)
{
    std::error_code failed;
    for (int i = 0; i < 200; ++i) {
        std::filesystem::remove_all(folder, failed);
        if (!failed) return;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    FAIL() << folder << ": " << failed.message();
}

}
