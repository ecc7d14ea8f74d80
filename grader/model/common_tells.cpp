#include "model/common_tells.hpp"

#include "model/enum_names.hpp"

namespace umbral::grader {
namespace {

constexpr std::array tells_names{
    EnumNames<CommonTells>{CommonTells::other, "", ""},
    EnumNames<CommonTells>{CommonTells::constant, "constant", ""},
    EnumNames<CommonTells>{CommonTells::place, "place", ""},
    EnumNames<CommonTells>{CommonTells::nearly, "nearly", ""},
    EnumNames<CommonTells>{CommonTells::mostly, "mostly", ""},
    EnumNames<CommonTells>{CommonTells::side, "side", ""},
    EnumNames<CommonTells>{CommonTells::multiple, "multiple", ""},
    EnumNames<CommonTells>{CommonTells::opposite, "opposite", ""},
    EnumNames<CommonTells>{CommonTells::one_sided, "one-sided", ""},
};

}

std::string_view to_string(CommonTells tells) { return names_of(tells_names, tells, "common_tells").in_json; }

CommonTells common_tells_from(std::string_view name) { return value_named(tells_names, name, "common_tells"); }

}
