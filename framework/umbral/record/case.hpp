#pragma once

#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <typeindex>
#include <umbral/core/random.hpp>
#include <umbral/record/variation.hpp>

namespace umbral {

/// What a driver is given to run one case: its name, random numbers from this case's seed, the text of files that are
/// not C++, and how inputs that are written down are to differ from what is written.
struct Case {
    std::string name;
    Random random;
    std::map<std::string, std::string, std::less<>> sources;
    Variation vary{};
    /// What was made once, by its type: copies of a case share it.
    std::shared_ptr<std::map<std::type_index, std::shared_ptr<void>>> made =
        std::make_shared<std::map<std::type_index, std::shared_ptr<void>>>();

    /// Something that takes long to make and is the same whatever is asked, such as a program of shaders: made by
    /// `make` when first wanted, and kept while the case is run again to be asked other questions. One of each type.
    template <class Make>
    [[nodiscard]] auto& once(const Make& make) const
    {
        using Made = std::remove_cvref_t<decltype(*make())>;
        std::shared_ptr<void>& kept = (*made)[std::type_index(typeid(Made))];
        if (!kept) kept = std::shared_ptr<Made>(make());
        return *static_cast<Made*>(kept.get());
    }

    /// The text of a submitted file (a shader, say). Throws std::out_of_range if the unit has no such file.
    [[nodiscard]] const std::string& source(std::string_view file) const
    {
        const auto found = sources.find(file);
        if (found == sources.end())
            throw std::out_of_range("case '" + name + "': no source file named '" + std::string(file) + "'");
        return found->second;
    }
};

}
