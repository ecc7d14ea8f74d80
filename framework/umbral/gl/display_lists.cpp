#include <algorithm>
#include <array>
#include <cstring>
#include <umbral/gl/display_lists.hpp>
#include <umbral/gl/effects.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/pixel_size.hpp>

namespace umbral::gl {
namespace {

template <class Number>
unsigned number_at(const unsigned char* place)
{
    Number number;
    std::memcpy(&number, place, sizeof number);
    return static_cast<unsigned>(static_cast<long long>(number));
}

/// One of the numbers that glCallLists takes. Of several bytes the first is the highest.
unsigned list_at(const unsigned char* place, GLenum type)
{
    switch (type) {
        case GL_BYTE: return number_at<GLbyte>(place);
        case GL_UNSIGNED_BYTE: return *place;
        case GL_SHORT: return number_at<GLshort>(place);
        case GL_UNSIGNED_SHORT: return number_at<GLushort>(place);
        case GL_INT: return number_at<GLint>(place);
        case GL_UNSIGNED_INT: return number_at<GLuint>(place);
        case GL_FLOAT: return number_at<GLfloat>(place);
        default: break;
    }
    unsigned number = 0;
    for (unsigned i = 0; i < type_size(type); ++i) number = number << 8U | place[i];
    return number;
}

}

void DisplayLists::note(std::string_view function, const CallArguments& arguments)
{
    if (function == "glNewList" && current_ == 0) {
        current_ = arguments.name(0);
        done_too_ = arguments.name(1) == GL_COMPILE_AND_EXECUTE;
        kept_ -= lists_[current_].size();
        lists_[current_].clear();
    } else if (function == "glEndList") {
        current_ = 0;
    } else if (function == "glListBase") {
        base_ = arguments.name(0);
    } else if (function == "glDeleteLists") {
        const double first = arguments.number(0);
        std::erase_if(lists_, [&](const auto& entry) {
            const bool gone =
                entry.first != current_ && entry.first >= first && entry.first < first + arguments.number(1);
            if (gone) kept_ -= entry.second.size();
            return gone;
        });
    }
}

bool DisplayLists::holds(std::string_view function)
{
    constexpr std::array at_once = {"glIs",          "glFlush",        "glFinish",          "glGen",
                                    "glCreate",      "glDelete",       "glRenderMode",      "glPixelStore",
                                    "glEnableC",     "glDisableC",     "glClientA",         "glFence",
                                    "glAttach",      "glDetach",       "glLinkProgram",     "glCompileShader",
                                    "glPushClient",  "glPopClient",    "glValidate",        "glBindV",
                                    "glEnableV",     "glDisableV",     "glVertexArray",     "glVertexAttribF",
                                    "glTexStorage",  "glTextureSto",   "glCopyBuffer",      "glBindBuf",
                                    "glFramebuffer", "glRenderbuffer", "glBindFramebuffer", "glBindRenderbuffer"};
    const Effect effect = effect_of(function);
    if (effect != Effect::none && effect != Effect::parameters && effect != Effect::draws) return false;
    return std::ranges::none_of(at_once, [&](const char* beginning) { return function.starts_with(beginning); });
}

void DisplayLists::add(Recorded recorded)
{
    if (kept_ >= Trace::maximum_calls) return;
    ++kept_;
    lists_[current_].push_back(std::move(recorded));
}

std::vector<unsigned> DisplayLists::called_by(std::string_view function, const CallArguments& arguments) const
{
    if (function == "glCallList") return {arguments.name(0)};
    const auto* place = static_cast<const unsigned char*>(arguments.pointer(2));
    const unsigned size = type_size(arguments.name(1));
    std::vector<unsigned> called;
    if (function != "glCallLists" || place == nullptr || size == 0) return called;
    const auto count =
        static_cast<std::size_t>(std::clamp(arguments.number(0), 0.0, static_cast<double>(Trace::maximum_calls)));
    for (std::size_t i = 0; i < count; ++i) called.push_back(base_ + list_at(place + i * size, arguments.name(1)));
    return called;
}

const std::vector<DisplayLists::Recorded>* DisplayLists::content_of(unsigned list) const
{
    const auto found = lists_.find(list);
    return found == lists_.end() ? nullptr : &found->second;
}

}
