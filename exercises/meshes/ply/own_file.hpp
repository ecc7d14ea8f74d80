#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <umbral/meshes/ply.hpp>
#include <umbral/record/case.hpp>
#include <umbral/record/recorder.hpp>

/// A file that the student gives (`umbral check meshes/ply --file FILE`): no check looks at it.
namespace umbral::meshes {

/// Rows of each table: the first ones, so that every file's recording has room. Counts are those of the whole mesh.
inline constexpr std::size_t most_rows_of_file = 1'000'000;

inline const char* name_of(PlyProblem problem)
{
    switch (problem) {
        case PlyProblem::not_ply: return "not_ply";
        case PlyProblem::header: return "header";
        case PlyProblem::missing_property: return "missing_property";
        case PlyProblem::truncated: return "truncated";
        case PlyProblem::left_over: return "left_over";
        case PlyProblem::number: return "number";
        case PlyProblem::line_length: return "line_length";
        case PlyProblem::index: return "index";
    }
    return "no PlyProblem";
}

/// The column of what came of a file: 0 if it was read, 99 for an exception that is no PlyError.
inline std::string problem_words()
{
    std::string words = "problem (0: none";
    for (int problem = 1; problem <= 8; ++problem)
        words += "; " + std::to_string(problem) + ": " + name_of(static_cast<PlyProblem>(problem));
    return words + "; 99: no PlyError)";
}

inline void record_mesh(Recorder& out, const PolygonMesh& mesh)
{
    std::size_t corners = 0;
    for (const std::vector<std::uint32_t>& face : mesh.faces) corners += face.size();
    out.append("vertices", static_cast<double>(mesh.positions.size()));
    out.append("faces", static_cast<double>(mesh.faces.size()));
    out.append("corners", static_cast<double>(corners));
    for (std::size_t i = 0; i < std::min(mesh.positions.size(), most_rows_of_file); ++i)
        out.append("vertex", mesh.positions[i]);
    for (std::size_t i = 0; i < std::min(mesh.faces.size(), most_rows_of_file); ++i)
        out.append("size of face", static_cast<std::uint32_t>(mesh.faces[i].size()));
    std::size_t left = most_rows_of_file;
    for (const std::vector<std::uint32_t>& face : mesh.faces) {
        const std::size_t shown = std::min(face.size(), left);
        for (std::size_t i = 0; i < shown; ++i) out.append("corner", face[i]);
        left -= shown;
    }
}

/// The mesh, or why there is none.
inline void record_own_file(const Case& what, Recorder& out)
{
    const std::string& file = what.source("own file");
    try {
        record_mesh(out, read_ply(std::as_bytes(std::span(file))));
        out.text("outcome", "read");
    } catch (const PlyError& error) {
        out.text("outcome", std::string("refused, ") + name_of(error.problem()));
        out.text("message", error.what());
    } catch (const std::exception& error) {
        out.text("outcome", "threw something else than PlyError");
        out.text("message", error.what());
    }
}

}
