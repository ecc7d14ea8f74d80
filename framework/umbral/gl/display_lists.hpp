#pragma once

#include <cstddef>
#include <map>
#include <string_view>
#include <umbral/gl/forward.hpp>
#include <umbral/gl/trace.hpp>
#include <vector>

/// What display lists hold, so that a trace sees what glCallList does. Private to libumbral-gl.
namespace umbral::gl {

#pragma GCC visibility push(hidden)

class DisplayLists {
public:
    struct Recorded {
        TracedCall call;
        std::vector<unsigned> lists;  ///< that it calls
    };

    /// Takes note of a call that makes or deletes lists, or chooses between them.
    void note(std::string_view function, const CallArguments& arguments);

    /// Is a list being made?
    [[nodiscard]] bool recording() const { return current_ != 0; }
    /// Is one being made, and nothing of it done yet?
    [[nodiscard]] bool only_recording() const { return recording() && !done_too_; }

    /// Would a list that is being made hold calls of this function? Others are done at once.
    [[nodiscard]] static bool holds(std::string_view function);
    void add(Recorded recorded);

    /// The lists that glCallList or glCallLists is about to do.
    [[nodiscard]] std::vector<unsigned> called_by(std::string_view function, const CallArguments& arguments) const;

    /// What a list holds, null for none; the first Trace::maximum_calls of all lists are kept.
    [[nodiscard]] const std::vector<Recorded>* content_of(unsigned list) const;

private:
    std::map<unsigned, std::vector<Recorded>> lists_;
    std::size_t kept_ = 0;
    unsigned base_ = 0;
    unsigned current_ = 0;
    bool done_too_ = false;
};

#pragma GCC visibility pop

}
