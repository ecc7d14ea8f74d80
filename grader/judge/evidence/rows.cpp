#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "judge/evidence/kinds.hpp"
#include "judge/explain/resemblances.hpp"
#include "judge/rows/columns.hpp"
#include "judge/rows/rows.hpp"
#include "judge/rows/tolerance.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t most_rows = 6;
constexpr std::size_t most_matrices = 1;
constexpr std::size_t most_columns = 8;

struct Candidate {
    std::size_t row = 0;
    double error = 0;  ///< infinite where it cannot be measured
};

/// Draws rows of two tables beside each other.
class RowWriter {
public:
    RowWriter(const Check& check, const TensorView& yours, const TensorView& expected, const RowKind& kind)
        : check_(check), yours_(yours), expected_(expected), kind_(kind)
    {
    }

    [[nodiscard]] double error(std::size_t row) const
    {
        if (!yours_.present(row) || !expected_.present(row)) return INFINITY;
        double worst = 0;
        for (std::size_t i = 0; i < expected_.components(); ++i) worst = std::max(worst, component(row, i).error);
        return worst;
    }

    [[nodiscard]] RowPair operator()(std::size_t row) const
    {
        RowPair pair;
        pair.name = fmt::format("{} {}", kind_.one, row);
        pair.cell = row;
        const bool both = yours_.present(row) && expected_.present(row);
        for (std::size_t i = 0; both && i < expected_.components(); ++i) {
            const auto [mine, right] = telling_apart([&](int digits) {
                return std::pair(kind_.show_number(yours_.cell(row), i, digits),
                                 kind_.show_number(expected_.cell(row), i, digits));
            });
            pair.yours.push_back(mine);
            pair.expected.push_back(right);
            pair.differs.push_back(!component(row, i).right);
        }
        if (!both) {
            pair.yours = texts_of(yours_, row);
            pair.expected = texts_of(expected_, row);
            pair.differs.assign(expected_.components(), true);
            pair.note = yours_.present(row) ? "nothing is expected" : "missing";
            return pair;
        }
        const double worst = error(row);
        pair.note = std::isfinite(worst) ? short_error(worst) : "not comparable";
        return pair;
    }

private:
    [[nodiscard]] Deviation component(std::size_t row, std::size_t index) const
    {
        const auto target = expected_.cell(row);
        return deviation(check_.tolerance, yours_.cell(row)[index], target[index], kind_.scale(target, index));
    }

    [[nodiscard]] std::string short_error(double error) const
    {
        switch (unit_of(check_.tolerance)) {
            case Unit::ulps: return error < no_rounding ? fmt::format("{:.3g} ulp", error) : "> 1e6 ulp";
            case Unit::relative: return fmt::format("{:.3g} of its size", error);
            case Unit::absolute: return fmt::format("{:.3g}", error);
        }
        return {};
    }

    static std::vector<std::string> texts_of(const TensorView& view, std::size_t row)
    {
        if (!view.present(row)) return {"nothing"};
        std::vector<std::string> texts;
        for (const double value : view.cell(row)) texts.push_back(number_text(value));
        return texts;
    }

    const Check& check_;
    const TensorView& yours_;
    const TensorView& expected_;
    const RowKind& kind_;
};

/// Of so many components with names, those that differ in no shown row are left out.
void leave_out_equal_columns(RowsEvidence& rows)
{
    if (rows.headings.size() <= most_columns) return;
    std::vector<bool> differs(rows.headings.size(), false);
    const auto each_row = [&](const auto& use) {
        for (std::vector<RowPair>* const list : {&rows.first, &rows.worst})
            for (RowPair& row : *list)
                if (row.yours.size() == differs.size() && row.expected.size() == differs.size()) use(row);
    };
    each_row([&](const RowPair& row) {
        for (std::size_t i = 0; i < differs.size(); ++i) differs[i] = differs[i] || row.differs[i];
    });
    if (std::ranges::none_of(differs, [](bool d) { return d; })) return;
    const auto thin_out = [&](auto& values) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < differs.size(); ++i)
            if (differs[i]) values[kept++] = values[i];
        values.resize(kept);
    };
    each_row([&](RowPair& row) {
        thin_out(row.yours);
        thin_out(row.expected);
        thin_out(row.differs);
    });
    thin_out(rows.headings);
    rows.equal_columns = differs.size() - rows.headings.size();
}

}

Evidence rows_evidence(const Check& check, const Observation& observation, bool right)
{
    if (right || shape_error(*observation.yours, *observation.expected)) return {};
    const RowKind& kind = rows_of(check);
    const bool matrices = &kind == &matrix_rows();
    const TensorView yours(*observation.yours);
    const TensorView expected(*observation.expected);
    const RowWriter write(check, yours, expected, kind);

    RowsEvidence result;
    if (!matrices) result.headings = column_names(text_of(observation.names), expected.components(), check.value);
    if (matrices) result.side = expected.components() == 9 ? 3 : expected.components() == 16 ? 4 : 0;
    std::vector<Candidate> wrong;
    const std::vector<RowState> states =
        row_states(check, *observation.yours, *observation.expected, observation.margin, kind);
    for (std::size_t i = 0; i < states.size(); ++i) {
        if (states[i] != RowState::left_out) ++result.rows;
        if (states[i] == RowState::wrong) wrong.push_back({i, write.error(i)});
    }
    result.wrong = wrong.size();
    const std::size_t most = matrices ? most_matrices : most_rows;
    const std::size_t shown = std::min(wrong.size(), wrong.size() <= 2 * most && !matrices ? 2 * most : most);
    for (std::size_t i = 0; i < shown; ++i) result.first.push_back(write(wrong[i].row));
    wrong.erase(wrong.begin(), wrong.begin() + static_cast<std::ptrdiff_t>(shown));
    std::stable_sort(wrong.begin(), wrong.end(),
                     [](const Candidate& a, const Candidate& b) { return a.error > b.error; });
    for (std::size_t i = 0; i < std::min(wrong.size(), most); ++i) result.worst.push_back(write(wrong[i].row));
    leave_out_equal_columns(result);
    return result;
}

}
