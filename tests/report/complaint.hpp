#pragma once

#include <exception>
#include <string>

/// What `action` says when it fails; empty if it does not fail.
template <class Action>
std::string complaint(Action action)
{
    try {
        action();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}
