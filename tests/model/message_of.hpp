#pragma once

#include <exception>
#include <string>

namespace umbral::grader::test {

/// What the exception says that `action` throws; "nothing was thrown" if none is.
template <class Action>
std::string message_of(Action&& action)
{
    try {
        action();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "nothing was thrown";
}

}
