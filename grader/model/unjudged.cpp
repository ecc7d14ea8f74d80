#include "model/unjudged.hpp"

#include "model/enum_names.hpp"

namespace umbral::grader {
namespace {

constexpr std::array unjudged_names{
    EnumNames<Unjudged>{Unjudged::no, "", ""},
    EnumNames<Unjudged>{Unjudged::unwritten, "unwritten", "not implemented yet"},
    EnumNames<Unjudged>{Unjudged::stopped, "stopped", "no result"},
    EnumNames<Unjudged>{Unjudged::not_run, "not_run", "not run"},
    EnumNames<Unjudged>{Unjudged::wrong_answers, "wrong_answers", "not measured: its answers are wrong"},
};

}

std::string_view to_string(Unjudged unjudged) { return names_of(unjudged_names, unjudged, "unjudged").in_json; }

std::string_view in_words(Unjudged unjudged) { return names_of(unjudged_names, unjudged, "unjudged").in_words; }

Unjudged unjudged_from(std::string_view name) { return value_named(unjudged_names, name, "unjudged"); }

}
