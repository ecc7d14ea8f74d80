#include <dlfcn.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>
#include <umbral/gl/effects.hpp>
#include <umbral/gl/generate/prototypes.hpp>

#include "elf.hpp"

// What each function of the generated interface does with the application's memory, so that no way to move data is
// overlooked.
namespace umbral::gl {
namespace {

std::string text_of(const char* path)
{
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// The functions of which the generator made the library.
const std::vector<generate::Prototype>& functions()
{
    static const std::vector<generate::Prototype> all = [] {
        std::vector<generate::Prototype> list =
            generate::prototypes(generate::without_comments(text_of(UMBRAL_GL_HEADERS "/GL/gl.h")));
        const std::string later = generate::without_comments(text_of(UMBRAL_GL_HEADERS "/GL/glext.h"));
        for (generate::Prototype& each : generate::prototypes(generate::core_versions(later, 4, 5)))
            list.push_back(std::move(each));
        return list;
    }();
    return all;
}

bool takes_or_gives_a_pointer(const generate::Prototype& function)
{
    const auto is_pointer = [](const std::string& text) {
        return text.find('*') != std::string::npos || text.find('[') != std::string::npos ||
               text.find("PROC") != std::string::npos;
    };
    if (is_pointer(function.result)) return true;
    for (const generate::Parameter& parameter : function.parameters)
        if (is_pointer(parameter.declaration)) return true;
    return false;
}

std::set<std::string> exported()
{
    std::set<std::string> names;
    for (const std::string& name : read_exports(UMBRAL_GL_LIBRARY).functions)
        if (name.starts_with("gl")) names.insert(name);
    return names;
}

}

TEST(Effects, every_function_with_a_pointer_is_classified)
{
    std::size_t pointers = 0;
    for (const generate::Prototype& function : functions()) {
        if (!takes_or_gives_a_pointer(function)) continue;
        ++pointers;
        EXPECT_NE(effect_of(function.name), Effect::none)
            << function.name
            << " takes or gives a pointer: say in framework/umbral/gl/effects.cpp what it does with it";
    }
    EXPECT_GT(pointers, 400U);
}

TEST(Effects, functions_that_move_data_in_take_a_pointer_or_are_shared_memory)
{
    for (const generate::Prototype& function : functions()) {
        const Effect effect = effect_of(function.name);
        if (effect == Effect::uploads || effect == Effect::array || effect == Effect::points) {
            EXPECT_TRUE(takes_or_gives_a_pointer(function)) << function.name;
        }
        const bool text =
            function.name.find("Data") != std::string::npos || function.name.find("Image") != std::string::npos;
        const bool inside =
            function.name.find("Copy") != std::string::npos || function.name.find("Get") != std::string::npos;
        if (text && !inside && takes_or_gives_a_pointer(function) && effect != Effect::objects) {
            EXPECT_EQ(effect, Effect::uploads) << function.name;
        }
    }
}

TEST(Effects, sizes_are_where_the_header_has_them)
{
    for (const generate::Prototype& function : functions()) {
        const FunctionRule* rule = rule_of(function.name);
        if (rule == nullptr || (rule->effect != Effect::uploads && rule->effect != Effect::array)) continue;
        const Size& size = rule->size;
        const auto declared = [&](std::size_t i) {
            return i < function.parameters.size() ? function.parameters[i].declaration : std::string("nothing");
        };
        ASSERT_NE(size.kind, Size::Kind::none) << function.name;
        if (size.kind != Size::Kind::fixed && size.kind != Size::Kind::uniforms) {
            EXPECT_NE(declared(size.pointer).find('*'), std::string::npos)
                << function.name << ": " << declared(size.pointer);
        }
        if (size.kind == Size::Kind::bytes) {
            EXPECT_TRUE(declared(size.first).find("ize") != std::string::npos ||
                        declared(size.first).find("length") != std::string::npos)
                << function.name << ": " << declared(size.first);
        }
        if (size.kind == Size::Kind::uniforms) {
            EXPECT_NE(declared(size.first).find("count"), std::string::npos) << function.name;
        }
        if (size.kind == Size::Kind::picture) {
            {
                EXPECT_NE(declared(size.pointer - 2).find("format"), std::string::npos) << function.name;
            }
            EXPECT_NE(declared(size.pointer - 1).find("type"), std::string::npos) << function.name;
            const std::vector<std::string> extents = {"width", "height", "depth"};
            for (std::size_t i = 0; i < size.dimensions; ++i) {
                const std::string extent = declared(size.first + i);
                EXPECT_TRUE(extent.find(extents[i]) != std::string::npos || extent.find("count") != std::string::npos)
                    << function.name << ": " << extent;
            }
        }
    }
}

TEST(Effects, a_vendors_suffix_changes_nothing)
{
    for (const generate::Prototype& function : functions())
        for (const char* suffix : {"ARB", "EXT", "NV", "APPLE", "OES"})
            EXPECT_EQ(rule_of(function.name + suffix), rule_of(function.name)) << function.name << suffix;
    EXPECT_EQ(effect_of("glMapBufferARB"), Effect::maps);
    EXPECT_EQ(effect_of("glMultiDrawArraysEXT"), Effect::draws);
    EXPECT_EQ(effect_of("glFlushMappedBufferRangeAPPLE"), Effect::maps);
    EXPECT_TRUE(is_always_seen("glMapBuffer"));
    EXPECT_FALSE(is_always_seen("glVertex3f"));
}

// Whoever cannot name a function cannot call it: what the library gives out is what was classified, and nothing finds
// more.
TEST(Effects, nothing_else_is_handed_out)
{
    std::set<std::string> generated;
    for (const generate::Prototype& function : functions()) generated.insert(function.name);
    EXPECT_EQ(exported(), generated);
    for (const std::string& name : read_exports(UMBRAL_GL_LIBRARY).functions) {
        EXPECT_EQ(name.find("ProcAddress"), std::string::npos) << name;
        EXPECT_EQ(name.find("entr"), std::string::npos) << name;
    }
    for (const generate::Prototype& function : functions())
        if (function.result.find('*') != std::string::npos) {
            EXPECT_TRUE(function.name.starts_with("glGetString") || function.name.starts_with("glMap"))
                << function.name;
        }
}

}
