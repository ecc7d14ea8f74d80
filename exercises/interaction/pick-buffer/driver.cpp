#include <limits>
#include <umbral/record/driver.hpp>

#include "board.hpp"
#include "sessions.hpp"

namespace umbral {
namespace {

using namespace interaction;
using Words = std::vector<std::uint32_t>;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

// Squares from a sixteenth of a pixel to larger than the picture; each tenth pixel is so far away that twice its column
// or row is no int, and its square no smaller than a pixel: in double, the difference of its sides would not have the
// digits of its length.
void record_matrices(Recorder& out, Random& random)
{
    for (int i = 0; i < 100; ++i) {
        const int width = 1 + static_cast<int>(random.below(2000));
        const glm::ivec2 picture(width, 1 + static_cast<int>(random.below(2000)));
        const int column = static_cast<int>(random.uniform(-0.2F, 1.2F) * static_cast<float>(width));
        glm::ivec2 pixel(column, static_cast<int>(random.uniform(-0.2F, 1.2F) * static_cast<float>(picture.y)));
        const int far_off = static_cast<int>((1U << 30U) + random.below((1U << 30U) - 5000));
        if (i % 10 == 0) pixel[i / 10 % 2] = i % 40 < 20 ? far_off : -far_off;
        const float size = i % 3 == 0 && i % 10 != 0 ? std::exp2(random.uniform(-4, 12)) : random.uniform(1, 40);
        out.append("matrix", ask<pick_matrix>(out, pixel, size, picture));
        // The same pixel in a larger square, and in another picture, of which it may be the size.
        if (i % 10 != 1) continue;
        for (const glm::ivec2& other :
             {picture, {picture.x, picture.y + 1}, {picture.x + 1, picture.y + 1}, pixel + 300})
            out.append("matrix", ask<pick_matrix>(out, pixel, size + 3, glm::max(other, 1)));
        out.append("matrix", ask<pick_matrix>(out, picture, 1 + size / 64, picture));
    }
}

void record_matrices_by_hand(Variation& vary, Recorder& out)
{
    const auto record = [&](const glm::ivec2& pixel, float size, const glm::ivec2& picture) {
        out.append("matrix", ask<pick_matrix>(out, pixel, vary.scaled(size, 1.4F), picture));
    };
    record({0, 0}, 1, {1, 1});
    record({0, 0}, 1, {2, 2});
    record({1, 0}, 1, {2, 2});
    record({0, 1}, 1, {2, 4});
    record({3, 1}, 5, {10, 5});
    record({320, 240}, 5, {640, 480});
    record({0, 479}, 5, {640, 480});
    record({100, 50}, 2.5F, {800, 600});
    record({-3, 700}, 4, {800, 600});
}

/// `crafted` says how many records and names are expected: each has its row, and NaN where there is none.
void record_parsed(Recorder& out, const Words& words, const std::vector<SelectionRecord>& crafted)
{
    const auto parsed = ask<parse_selection>(out, words, static_cast<int>(crafted.size()));
    out.columns("records", "number of records (-1: nothing)");
    out.append("records", parsed ? static_cast<float>(parsed->size()) : -1.0F);
    out.columns("depths", "min_depth, max_depth");
    for (std::size_t i = 0; i < crafted.size(); ++i) {
        const bool is_there = parsed && i < parsed->size();
        out.append("depths",
                   is_there ? glm::dvec2((*parsed)[i].min_depth, (*parsed)[i].max_depth) : glm::dvec2(no_number));
        const Words names = is_there ? (*parsed)[i].names : Words{};
        out.append("names", is_there ? static_cast<double>(names.size()) : no_number);
        for (std::size_t k = 0; k < crafted[i].names.size(); ++k)
            out.append("names", k < names.size() ? static_cast<double>(names[k]) : no_number);
    }
}

void record_parsing(Recorder& out, Random& random)
{
    const std::vector<SelectionRecord> known[] = {{{10, 20, {3}}},
                                                  {{10, 20, {3, 4}}, {5, 6, {}}, {7, 7, {1, 2, 3, 4}}},
                                                  {},
                                                  {{0, 4294967295U, {}}},
                                                  {{0x90000000U, 0xA0000000U, {8}}, {0x10000000U, 0xF0000000U, {9}}}};
    const auto record = [&](const std::vector<SelectionRecord>& crafted, std::uint32_t behind) {
        Words words;
        for (const SelectionRecord& one : crafted) append_words(words, one);
        for (std::uint32_t i = 0; i < behind; ++i) words.push_back(random.bits());
        record_parsed(out, words, crafted);
    };
    for (const std::vector<SelectionRecord>& crafted : known) record(crafted, 0);
    for (int i = 0; i < 40; ++i) {
        std::vector<SelectionRecord> crafted(random.below(7));
        for (SelectionRecord& one : crafted) one = random_record(random);
        if (i % 20 == 5) crafted.push_back(record_of_many_names(random));
        record(crafted, random.below(5));
    }
}

// Whole buffers, and their twins: overflowed, cut short, with a record too few or nearly all that an int counts, or a
// number of names that leads out.
void record_damaged(Recorder& out, Random& random)
{
    for (int i = 0; i < 49; ++i) {
        std::vector<SelectionRecord> crafted(1 + random.below(4));
        for (SelectionRecord& one : crafted) one = random_record(random);
        if (i % 6 == 1) crafted.front() = record_of_many_names(random);
        Words words;
        std::size_t last = 0;
        for (const SelectionRecord& one : crafted) {
            last = words.size();
            append_words(words, one);
        }
        const auto count = static_cast<int>(crafted.size());
        Words damaged = words;
        int damaged_count = count;
        switch (i % 7) {
            case 0: damaged_count = -1; break;
            case 1: damaged_count = count + 1; break;
            case 2: damaged.pop_back(); break;
            case 3: damaged[last] = ~0U - random.below(4); break;
            case 4: damaged[last] += 1; break;
            case 5: damaged_count = std::numeric_limits<int>::max() - static_cast<int>(random.below(1000)); break;
            default: damaged.resize(last + random.below(3));
        }
        const bool first = random.below(2) == 0;
        for (const bool whole : {first, !first}) {
            const auto parsed = ask<parse_selection>(out, whole ? words : damaged, whole ? count : damaged_count);
            out.append("found", parsed.has_value());
        }
    }
}

void record_nearest(Recorder& out, Random& random)
{
    const auto record = [&](const std::vector<SelectionRecord>& records) {
        const std::optional<std::size_t> nearest = ask<nearest_record>(out, records);
        out.append("nearest", nearest ? std::optional(static_cast<float>(*nearest)) : std::nullopt);
    };
    record({{0x90000000U, 0xA0000000U, {8}}, {0x10000000U, 0xF0000000U, {9}}});
    record({{0x10000000U, 0xF0000000U, {9}}, {0x90000000U, 0xA0000000U, {8}}});
    record({{~0U, ~0U, {1}}});
    record({});
    record({{7, 9, {1}}, {7, 8, {2}}, {7, 7, {}}});
    for (int i = 0; i < 80; ++i) {
        std::vector<SelectionRecord> records(i % 10 == 0 ? 0 : 2 + random.below(7));
        for (SelectionRecord& one : records) one = random_record(random);
        // Two are equally near, and nearer than all others.
        if (i % 3 == 0 && records.size() > 2) {
            const std::uint32_t least = random.below(1U << 16U);
            records.back().min_depth = least;
            records[records.size() / 2].min_depth = least;
        }
        // One is nearer than another by a single step, of which a float knows nothing.
        if (i % 3 == 1 && !records.empty()) {
            for (SelectionRecord& one : records) one.min_depth = (1U << 31U) + one.min_depth / 2;
            const std::uint32_t least = (1U << 30U) + random.below(1U << 29U);
            records[records.size() / 2].min_depth = least + 1;
            records.back().min_depth = least;
        }
        // All begin at the far plane.
        if (i % 10 == 5)
            for (SelectionRecord& one : records) one.min_depth = one.max_depth = ~0U;
        record(records);
    }
}

void record_by_hand(Recorder& out)
{
    const std::vector<NameCommand> sessions[] = {
        {init(), push(5), note(0, 1)},
        {push(1), note(0, 1), push(2), note(0, 0), pop(), note(1, 1), pop()},
        {note(0, 0), note(1, 1)},
        {init(), push(7), push(8), init(), push(9), note(0, 1), load(10), load(11), note(1, 1), load(12)},
        {push(1), push(2), pop(), pop()},
        {push(3), note(0, 1), load(3), note(0, 0), push(4), pop(), note(1, 1)},
        {pop(), load(5), note(0, 1), pop(), note(0, 0), load(1), push(2)},
        {push(4000000000U), note(0, 1), init(), note(0, 1), init()}};
    for (const std::vector<NameCommand>& commands : sessions) record_sessions(out, {commands}, 16);
}

void record_random(Recorder& out, Random& random)
{
    for (int i = 0; i < 10; ++i) {
        std::vector<std::vector<NameCommand>> sessions(4);
        for (std::vector<NameCommand>& commands : sessions) commands = random_commands(random, 16);
        record_sessions(out, sessions, 200);
    }
}

// Two buffers by turns, each for several selections; names that were left on the stack are gone with the first.
void record_again(Recorder& out, Random& random)
{
    for (int i = 0; i < 8; ++i) {
        const auto first = ask_new<make_selection_buffer>(out, "first", std::size_t{100});
        const auto second = ask_new<make_selection_buffer>(out, "second", std::size_t{100});
        if (!first || !second) return;
        for (int round = 0; round < 3; ++round) {
            for (const NameCommand& command : random_commands(random, 20))
                carry_out(out, random.below(2) == 0 ? *first : *second, command);
            // Both end, and only then is what they left looked at.
            const int first_count = record_count(out, *first);
            const int second_count = round == 1 ? record_count(out, *second) : 0;
            record_words(out, *first, first_count, 24);
            if (round == 1) record_words(out, *second, second_count, 24);
        }
    }
}

// Depths that are no whole number of steps: the nearest one counts. One selection after the other, so that a range that
// is kept from any of them shows in all that follow.
void record_depths(Recorder& out, Random& random)
{
    const auto buffer = ask_new<make_selection_buffer>(out, "buffer", std::size_t{12});
    if (!buffer) return;
    for (int i = 0; i < 40; ++i) {
        const double step = 1 / 4294967295.0;
        const double one = (random.bits() + (i % 2 == 0 ? 0.7 : 0.3)) * step;
        const double any = (random.bits() + (i % 2 == 0 ? 0.3 : 0.7)) * step;
        const double other = i % 8 == 3 ? one : any;
        const auto names = static_cast<std::uint32_t>(i % 3);
        for (std::uint32_t name = 0; name < names; ++name) carry_out(out, *buffer, push(name));
        carry_out(out, *buffer, note(std::min(1.0, std::min(one, other)), std::min(1.0, std::max(one, other))));
        // Further ones between them change nothing, further ones outside do.
        if (i % 4 == 1) carry_out(out, *buffer, note(0.5 * (one + other), 0.5 * (one + other)));
        if (i % 4 == 2) carry_out(out, *buffer, note(0.25 * step, 1));
        record_head(out, *buffer);
    }
}

// Buffers that the records fill to the last word, and their twins: a word too small for the last record, or too
// small by all of it, or too small for the largest, which is the first. Of two buffers of no
// words at all, one gets a record. And what comes after.
void record_overflow(Recorder& out, Random& random)
{
    for (int i = 0; i < 32; ++i) {
        const bool first_largest = i % 4 == 1;
        const bool no_words = i % 4 == 3;
        const std::uint32_t depth = random.below(4);
        const std::uint32_t first_depth = first_largest ? 8 + random.below(4) : depth;
        const std::uint32_t records = first_largest ? 2 : no_words ? 1 : 1 + random.below(3);
        const std::size_t needed = 3 + first_depth + std::size_t{records - 1} * (3 + depth);
        const std::size_t without_last = needed - 3 - (records == 1 ? first_depth : depth);
        const std::size_t too_small = first_largest ? 2 + first_depth : i % 4 == 0 ? needed - 1 : without_last;
        const bool first = random.below(2) == 0;
        for (const bool fits : {first, !first}) {
            const std::size_t capacity = no_words ? 0 : fits ? needed : too_small;
            const auto buffer = ask_new<make_selection_buffer>(out, "buffer", capacity);
            if (!buffer) continue;
            const std::uint32_t times = no_words && fits ? 0 : records;
            for (std::uint32_t k = 0; k < times; ++k) {
                carry_out(out, *buffer, init());
                for (std::uint32_t name = 0; name < (k == 0 ? first_depth : depth); ++name)
                    carry_out(out, *buffer, push(10 * k + name));
                carry_out(out, *buffer, note(0.25, 0.75));
            }
            out.append("overflow", static_cast<float>(ask<&SelectionBuffer::finish>(out, *buffer)));
            // The next selection is not to blame: it begins without names, and may have nothing to write.
            const std::uint32_t hits = random.below(4);
            for (std::uint32_t k = 0; k < hits; ++k) {
                carry_out(out, *buffer, note(0, 1));
                carry_out(out, *buffer, init());
            }
            const int count = ask<&SelectionBuffer::finish>(out, *buffer);
            out.append("next", static_cast<float>(count));
            const std::span<const std::uint32_t> written = ask<&SelectionBuffer::words>(out, *buffer);
            const bool is_known = count > 0 && !written.empty();
            out.append("next names", is_known ? std::optional(static_cast<float>(written.front())) : std::nullopt);
        }
    }
}

}

const Driver driver = {
    {"matrices by hand", [](Case& c, Recorder& out) { record_matrices_by_hand(c.vary, out); }},
    {"matrices", [](Case& c, Recorder& out) { record_matrices(out, c.random); }},
    {"parsing", [](Case& c, Recorder& out) { record_parsing(out, c.random); }},
    {"damaged", [](Case& c, Recorder& out) { record_damaged(out, c.random); }},
    {"nearest", [](Case& c, Recorder& out) { record_nearest(out, c.random); }},
    {"by hand", [](Case&, Recorder& out) { record_by_hand(out); }},
    {"random", [](Case& c, Recorder& out) { record_random(out, c.random); }},
    {"again", [](Case& c, Recorder& out) { record_again(out, c.random); }},
    {"depths", [](Case& c, Recorder& out) { record_depths(out, c.random); }},
    {"overflow", [](Case& c, Recorder& out) { record_overflow(out, c.random); }},
    {"limits", [](Case& c, Recorder& out) { record_limits(out, c.random); }},
    {"picture", [](Case&, Recorder& out) { out.image("board", chess_board(out, 480, 320)); }},
};

}
