#include "collect/roster.hpp"

#include <fmt/format.h>

#include <map>
#include <set>
#include <stdexcept>

#include "collect/submission_id.hpp"
#include "collect/text_encoding.hpp"
#include "model/caps.hpp"

namespace umbral::grader {
namespace {

[[noreturn]] void fail(const std::string& where, std::size_t line, const std::string& what)
{
    throw std::runtime_error(fmt::format("{}:{}: {}", where, line, what));
}

struct Record {
    std::vector<std::string> fields;
    std::size_t line = 0;
};

/// Splits CSV into records, one after the other.
class CsvReader {
public:
    /// The first line tells what stands between fields: a semicolon, as spreadsheets write where numbers have commas,
    /// or a comma.
    CsvReader(std::string_view text, const std::string& where)
        : rest_(text),
          where_(where),
          separator_(text.substr(0, text.find('\n')).find(';') == std::string_view::npos ? ',' : ';')
    {
    }

    [[nodiscard]] bool at_end() const { return rest_.empty(); }

    Record next()
    {
        Record record{{}, line_};
        for (;;) {
            record.fields.push_back(!rest_.empty() && rest_.front() == '"' ? quoted() : plain());
            if (rest_.empty()) return record;
            const char separator = rest_.front();
            rest_.remove_prefix(1);
            if (separator == separator_) continue;
            ++line_;
            return record;
        }
    }

private:
    std::string plain()
    {
        const std::size_t end = std::min({rest_.find(separator_), rest_.find('\n'), rest_.size()});
        std::string field(rest_.substr(0, end));
        rest_.remove_prefix(end);
        if (field.ends_with('\r')) field.pop_back();
        if (field.find('"') != std::string::npos)
            fail(where_, line_, "a quote within a field: write the whole field in quotes, and each quote in it twice");
        return field;
    }

    std::string quoted()
    {
        const std::size_t begun = line_;
        std::string field;
        rest_.remove_prefix(1);
        for (;;) {
            const std::size_t end = rest_.find('"');
            if (end == std::string_view::npos) fail(where_, begun, "the quote that begins here does not end");
            for (const char c : rest_.substr(0, end)) line_ += c == '\n' ? 1 : 0;
            field += rest_.substr(0, end);
            rest_.remove_prefix(end + 1);
            if (!rest_.starts_with('"')) break;
            field += '"';
            rest_.remove_prefix(1);
        }
        if (rest_.starts_with("\r\n")) rest_.remove_prefix(1);
        if (!rest_.empty() && rest_.front() != separator_ && rest_.front() != '\n')
            fail(where_, line_, fmt::format("expected '{}' or the end of the line behind a quoted field", separator_));
        return field;
    }

    std::string_view rest_;
    std::string where_;
    char separator_;
    std::size_t line_ = 1;
};

}

std::vector<RosterEntry> parse_roster(std::string_view text, const std::string& where)
{
    const std::string utf8 = as_utf8(std::string(text));
    CsvReader reader(utf8, where);
    const Record header = reader.at_end() ? Record{{}, 1} : reader.next();
    const std::vector<std::string> columns{"folder", "id", "name"};
    if (header.fields != columns && header.fields != std::vector<std::string>{"folder", "id"})
        fail(where, 1, "expected the first line to name the columns: folder,id or folder,id,name");
    std::vector<RosterEntry> entries;
    std::map<std::string, std::size_t> folders;
    std::map<std::string, std::size_t> ids;
    while (!reader.at_end()) {
        Record record = reader.next();
        if (record.fields == std::vector<std::string>{""}) continue;
        if (record.fields.size() != header.fields.size())
            fail(where, record.line,
                 fmt::format("expected {} fields, got {}", header.fields.size(), record.fields.size()));
        record.fields.resize(columns.size());
        const auto& [folder, id, name] = std::tie(record.fields[0], record.fields[1], record.fields[2]);
        if (folder.empty() || folder.find('/') != std::string::npos)
            fail(where, record.line,
                 fmt::format("expected the name of a folder in the class's folder, got '{}'", one_line(folder)));
        if (!is_submission_id(id) || is_reserved_id(id))
            fail(where, record.line,
                 fmt::format("expected an id of at most 128 letters, digits, '.', '_' and '-' that does not begin with "
                             "'.' or '-' nor end in "
                             ".json, .html or .csv, got '{}'",
                             one_line(id)));
        const auto only_once = [&](std::map<std::string, std::size_t>& seen, const std::string& what,
                                   const std::string& value) {
            const auto [before, fresh] = seen.emplace(value, record.line);
            if (!fresh)
                fail(where, record.line,
                     fmt::format("the {} '{}' stands in line {} already", what, one_line(value), before->second));
        };
        only_once(folders, "folder", folder);
        only_once(ids, "id", id);
        entries.push_back({folder, id, name, record.line});
    }
    return entries;
}

}
