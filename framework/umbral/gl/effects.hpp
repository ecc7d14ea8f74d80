#pragma once

#include <cstddef>
#include <string_view>

namespace umbral::gl {

/// What a function of OpenGL does with the application's memory, which decides how a trace counts it.
enum class Effect {
    none,        ///< takes nothing but numbers, and gives nothing but a number
    uploads,     ///< copies bytes of the application: they are counted at the call
    parameters,  ///< takes a few numbers by a pointer (a colour, a matrix, one uniform): counts like numbers passed one
                 ///< by one, not as data
    array,       ///< parameters if it is given one element, uploads if it is given several: uniforms
    program,     ///< takes the text of programs: they are counted as objects, not as data
    objects,     ///< takes or gives names of objects, or texts that describe them
    reads_back,  ///< copies to the application
    maps,        ///< shares a buffer's memory with the application, or ends that
    points,      ///< notes where the application's memory is: what draws read of it is counted when they do
    draws,       ///< draws, and reads memory that was noted or is shared
    lists,       ///< makes or deletes display lists, or chooses between them
};

/// Where the arguments say how many bytes an upload has; arguments are counted from 0.
struct Size {
    enum class Kind {
        none,
        bytes,    ///< argument `first` is the number of bytes; `pointer` must not be null
        picture,  ///< `dimensions` extents from argument `first` on; format, type and address of the pixels end at
                  ///< argument `pointer`
        bits,     ///< a picture of one bit a pixel, its rows in whole bytes
        items,    ///< argument `first` is a number of items of `item` bytes; of rows of them if `dimensions` names an
                  ///< argument too
        fixed,    ///< `item` bytes
        uniforms  ///< argument `first` is a number of elements, which the function's name describes
    };
    Kind kind = Kind::none;
    std::size_t first = 0;
    std::size_t pointer = 0;
    std::size_t dimensions = 0;
    std::size_t item = 0;
};

/// How functions whose names match one of `names` (separated by spaces; a '*' stands for any letters) are counted.
struct FunctionRule {
    std::string_view names;
    Effect effect = Effect::none;
    Size size{};
};

/// The first rule for a function in the one table of effects.cpp, null if there is none: then it must not take or give
/// any pointer, which a test demands of every function in libumbral-gl. A vendor's suffix is not looked at:
/// glMapBufferARB is glMapBuffer.
[[nodiscard]] const FunctionRule* rule_of(std::string_view function);

/// rule_of's effect; Effect::none without a rule.
[[nodiscard]] Effect effect_of(std::string_view function);

/// Must the library see each call of the function, also while no trace is running? What is mapped and what display
/// lists hold is remembered.
[[nodiscard]] bool is_always_seen(std::string_view function);

}
