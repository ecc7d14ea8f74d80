#pragma once

#include <algorithm>
#include <umbral/core/random.hpp>
#include <umbral/interaction/pick_buffer.hpp>
#include <umbral/record/ask.hpp>
#include <vector>

/// Selections: what is told a SelectionBuffer, and what is recorded of it.
namespace umbral::interaction {

/// One call of a SelectionBuffer's function.
struct NameCommand {
    enum class Kind { init, load, push, pop, note };
    Kind kind;
    std::uint32_t name = 0;
    double min_depth = 0;
    double max_depth = 0;
};

inline NameCommand init() { return {NameCommand::Kind::init}; }
inline NameCommand load(std::uint32_t name) { return {NameCommand::Kind::load, name}; }
inline NameCommand push(std::uint32_t name) { return {NameCommand::Kind::push, name}; }
inline NameCommand pop() { return {NameCommand::Kind::pop}; }
inline NameCommand note(double min_depth, double max_depth)
{
    return {NameCommand::Kind::note, 0, min_depth, max_depth};
}

/// The depth that a word stands for, but for a quarter of a step: nearest and next lower whole number are the word.
inline double depth_of_word(std::uint32_t word) { return std::min(1.0, (word + 0.25) / 4294967295.0); }

/// Depths over the whole range, every second one beyond the half; each third primitive faces the viewer, at one depth.
inline NameCommand random_note(Random& random)
{
    const std::uint32_t one = random.bits();
    const std::uint32_t between = one / 2 + (random.bits() >> 1U);
    const std::uint32_t other = random.below(3) == 0 ? one : between;
    return note(depth_of_word(std::min(one, other)), depth_of_word(std::max(one, other)));
}

/// `count` commands: primitives between all kinds of changes, and commands that are to be refused.
inline std::vector<NameCommand> random_commands(Random& random, int count)
{
    std::vector<NameCommand> commands;
    for (int i = 0; i < count; ++i) {
        // Also 0, which is a name like others, and small ones.
        const std::uint32_t name = i % 8 == 3 ? 0 : i % 8 == 6 ? random.below(3) : random.bits();
        const NameCommand primitive = random_note(random);
        const std::uint32_t kind = random.below(16);
        if (kind < 7)
            commands.push_back(primitive);
        else if (kind < 11)
            commands.push_back(push(name));
        else if (kind < 13)
            commands.push_back(load(name));
        else
            commands.push_back(kind < 15 ? pop() : init());
    }
    return commands;
}

/// Carries out a command; what is refused or not is a row of "accepted".
inline void carry_out(Recorder& out, SelectionBuffer& buffer, const NameCommand& command)
{
    const auto accepted = [&](bool answer) { out.append("accepted", answer); };
    switch (command.kind) {
        case NameCommand::Kind::init: ask<&SelectionBuffer::init_names>(out, buffer); break;
        case NameCommand::Kind::load: accepted(ask<&SelectionBuffer::load_name>(out, buffer, command.name)); break;
        case NameCommand::Kind::push: accepted(ask<&SelectionBuffer::push_name>(out, buffer, command.name)); break;
        case NameCommand::Kind::pop: accepted(ask<&SelectionBuffer::pop_name>(out, buffer)); break;
        case NameCommand::Kind::note:
            ask<&SelectionBuffer::note_primitive>(out, buffer, command.min_depth, command.max_depth);
    }
}

/// Ends the selection: the number of records, and the buffer's first words, -1 where it has none.
inline int record_count(Recorder& out, SelectionBuffer& buffer)
{
    const int count = ask<&SelectionBuffer::finish>(out, buffer);
    out.append("records", static_cast<float>(count));
    return count;
}

/// The first words of a buffer whose selection ended with `count` records.
inline void record_words(Recorder& out, const SelectionBuffer& buffer, int count, std::size_t words)
{
    const std::span<const std::uint32_t> written = ask<&SelectionBuffer::words>(out, buffer);
    const std::size_t known = count < 0 ? 0 : written.size();
    for (std::size_t i = 0; i < words; ++i) out.append("words", i < known ? static_cast<double>(written[i]) : -1.0);
}

/// The same of a record alone: the three words before its names, in one row.
inline void record_head(Recorder& out, SelectionBuffer& buffer)
{
    const int count = record_count(out, buffer);
    const std::span<const std::uint32_t> written = ask<&SelectionBuffer::words>(out, buffer);
    const bool is_there = count > 0 && written.size() >= 3;
    out.columns("words", "number of names, min_depth, max_depth");
    out.append("words", is_there ? std::optional(glm::dvec3(written[0], written[1], written[2])) : std::nullopt);
}

inline void record_end(Recorder& out, SelectionBuffer& buffer, std::size_t words)
{
    record_words(out, buffer, record_count(out, buffer), words);
}

/// One selection after another in the same buffer.
inline void record_sessions(Recorder& out, const std::vector<std::vector<NameCommand>>& sessions, std::size_t capacity)
{
    const auto buffer = ask_new<make_selection_buffer>(out, "buffer", capacity);
    if (!buffer) return;
    for (const std::vector<NameCommand>& commands : sessions) {
        for (const NameCommand& command : commands) carry_out(out, *buffer, command);
        record_end(out, *buffer, std::min<std::size_t>(capacity, 32));
    }
}

/// A record's words, as OpenGL writes them.
inline void append_words(std::vector<std::uint32_t>& words, const SelectionRecord& record)
{
    words.push_back(static_cast<std::uint32_t>(record.names.size()));
    words.push_back(record.min_depth);
    words.push_back(record.max_depth);
    words.insert(words.end(), record.names.begin(), record.names.end());
}

inline SelectionRecord random_record(Random& random)
{
    const std::uint32_t one = random.bits();
    const std::uint32_t other = random.bits();
    SelectionRecord record{std::min(one, other), std::max(one, other), {}};
    const std::uint32_t names = random.below(5);
    for (std::uint32_t i = 0; i < names; ++i) record.names.push_back(random.bits() >> random.below(32));
    return record;
}

/// With more names than a stack of OpenGL needs to have room for.
inline SelectionRecord record_of_many_names(Random& random)
{
    SelectionRecord record = random_record(random);
    record.names.resize(SelectionBuffer::most_names + 1 + random.below(20));
    for (std::uint32_t& name : record.names) name = random.bits();
    return record;
}

/// Sixty names and more: as many as there is room for, and those that are refused.
inline void record_limits(Recorder& out, Random& random)
{
    const auto buffer = ask_new<make_selection_buffer>(out, "buffer", std::size_t{400});
    if (!buffer) return;
    for (int round = 0; round < 2; ++round) {
        const std::uint32_t almost = 60 + random.below(5);
        for (std::uint32_t i = 0; i < almost; ++i) carry_out(out, *buffer, push(i));
        for (int i = 0; i < 5; ++i) carry_out(out, *buffer, push(1000));
        carry_out(out, *buffer, note(0, 1));
        carry_out(out, *buffer, push(2000));
        carry_out(out, *buffer, note(0, 0));
        carry_out(out, *buffer, load(3000));
        for (int i = 0; i < 67; ++i) carry_out(out, *buffer, pop());
        carry_out(out, *buffer, load(1));
        record_end(out, *buffer, 80);
    }
}

}
