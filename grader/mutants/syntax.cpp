#include "mutants/syntax.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <type_traits>

namespace umbral::grader {
namespace {

std::string taken(CXString string)
{
    const char* const text = clang_getCString(string);
    std::string copy = text == nullptr ? "" : text;
    clang_disposeString(string);
    return copy;
}

/// What visiting a tree needs to know.
struct Visit {
    CXFile file;
    std::vector<Node>* nodes;
};

struct Place {
    CXFile file = nullptr;
    unsigned line = 0;
    unsigned offset = 0;
};

Place place_of(CXSourceLocation location)
{
    Place place;
    clang_getFileLocation(location, &place.file, &place.line, nullptr, &place.offset);
    return place;
}

std::string type_of(CXCursor cursor)
{
    const CXCursorKind kind = clang_getCursorKind(cursor);
    const bool gives = clang_isDeclaration(kind) != 0 && kind != CXCursor_VarDecl && kind != CXCursor_ParmDecl;
    CXType type = gives ? clang_getCursorResultType(cursor) : clang_getCursorType(cursor);
    std::string name = taken(clang_getTypeSpelling(clang_getCanonicalType(type)));
    if (!gives && name.ends_with(" &")) name.resize(name.size() - 2);
    return name.starts_with("const ") ? name.substr(6) : name;
}

bool is_number(CXCursor cursor)
{
    CXType type = clang_getCanonicalType(clang_getCursorType(cursor));
    if (type.kind == CXType_LValueReference) type = clang_getCanonicalType(clang_getPointeeType(type));
    return (type.kind >= CXType_Bool && type.kind <= CXType_LongDouble) || type.kind == CXType_Enum;
}

/// The fields of a struct of one type, in their order.
struct Fields {
    CXType type;
    std::vector<std::string> names;
};

CXChildVisitResult take_field(CXCursor cursor, CXCursor /*parent*/, CXClientData data)
{
    auto& fields = *static_cast<Fields*>(data);
    if (clang_getCursorKind(cursor) == CXCursor_FieldDecl &&
        clang_equalTypes(clang_getCanonicalType(clang_getCursorType(cursor)), fields.type) != 0)
        fields.names.push_back(taken(clang_getCursorSpelling(cursor)));
    return CXChildVisit_Continue;
}

/// The field after the one that is named, of the same struct and type; after the last one comes the first.
std::string sibling_of(CXCursor cursor)
{
    const CXCursor field = clang_getCursorReferenced(cursor);
    if (clang_getCursorKind(field) != CXCursor_FieldDecl) return "";
    Fields fields{clang_getCanonicalType(clang_getCursorType(field)), {}};
    const CXCursor owner = clang_getCursorSemanticParent(field);
    // Of a union they are names for the same thing.
    if (clang_getCursorKind(owner) == CXCursor_UnionDecl) return "";
    clang_visitChildren(owner, take_field, &fields);
    const auto own = std::ranges::find(fields.names, taken(clang_getCursorSpelling(field)));
    if (fields.names.size() < 2 || own == fields.names.end()) return "";
    return own + 1 == fields.names.end() ? fields.names.front() : *(own + 1);
}

std::vector<Node> children_of(CXCursor cursor, CXFile file);

CXChildVisitResult take(CXCursor cursor, CXCursor /*parent*/, CXClientData data)
{
    const auto& visit = *static_cast<Visit*>(data);
    const CXSourceRange range = clang_getCursorExtent(cursor);
    const Place begin = place_of(clang_getRangeStart(range));
    const Place end = place_of(clang_getRangeEnd(range));
    const CXCursorKind kind = clang_getCursorKind(cursor);
    if (begin.file == nullptr || clang_File_isEqual(begin.file, visit.file) == 0 || end.offset < begin.offset)
        return CXChildVisit_Continue;
    Node node{kind,
              begin.offset,
              end.offset,
              begin.line,
              type_of(cursor),
              taken(clang_getCursorSpelling(cursor)),
              kind == CXCursor_MemberRefExpr ? sibling_of(cursor) : "",
              is_number(cursor),
              children_of(cursor, visit.file)};
    // Casts and temporaries that the compiler added.
    if (kind == CXCursor_UnexposedExpr && node.children.size() == 1)
        visit.nodes->push_back(std::move(node.children.front()));
    else
        visit.nodes->push_back(std::move(node));
    return CXChildVisit_Continue;
}

std::vector<Node> children_of(CXCursor cursor, CXFile file)
{
    std::vector<Node> nodes;
    Visit visit{file, &nodes};
    clang_visitChildren(cursor, take, &visit);
    // An operator comes before what it stands between.
    std::ranges::stable_sort(nodes, {}, &Node::begin);
    return nodes;
}

bool is_function(CXCursorKind kind)
{
    return kind == CXCursor_FunctionDecl || kind == CXCursor_CXXMethod || kind == CXCursor_Constructor ||
           kind == CXCursor_FunctionTemplate;
}

void take_functions(std::vector<Node> nodes, std::vector<Node>& functions)
{
    for (Node& node : nodes) {
        if (is_function(node.kind))
            functions.push_back(std::move(node));
        else if (node.kind == CXCursor_Namespace || node.kind == CXCursor_StructDecl ||
                 node.kind == CXCursor_ClassDecl || node.kind == CXCursor_ClassTemplate ||
                 node.kind == CXCursor_UnexposedDecl || node.kind == CXCursor_LinkageSpec)
            take_functions(std::move(node.children), functions);
    }
}

std::string read(const std::string& file)
{
    std::ifstream stream(file);
    if (!stream) throw std::runtime_error("cannot read '" + file + "'");
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}

Syntax parse(const std::string& file, const std::vector<std::string>& flags)
{
    std::vector<const char*> words;
    for (const std::string& flag : flags) words.push_back(flag.c_str());
    const std::unique_ptr<void, decltype(&clang_disposeIndex)> index(clang_createIndex(0, 0), clang_disposeIndex);
    const std::unique_ptr<std::remove_pointer_t<CXTranslationUnit>, decltype(&clang_disposeTranslationUnit)> unit(
        clang_parseTranslationUnit(index.get(), file.c_str(), words.data(), static_cast<int>(words.size()), nullptr, 0,
                                   CXTranslationUnit_None),
        clang_disposeTranslationUnit);
    if (!unit) throw std::runtime_error("libclang cannot parse '" + file + "'");
    for (unsigned i = 0; i < clang_getNumDiagnostics(unit.get()); ++i) {
        CXDiagnostic diagnostic = clang_getDiagnostic(unit.get(), i);
        const bool error = clang_getDiagnosticSeverity(diagnostic) >= CXDiagnostic_Error;
        const std::string text = taken(clang_formatDiagnostic(diagnostic, clang_defaultDiagnosticDisplayOptions()));
        clang_disposeDiagnostic(diagnostic);
        if (error) throw std::runtime_error(text);
    }
    Syntax syntax;
    syntax.text = read(file);
    take_functions(children_of(clang_getTranslationUnitCursor(unit.get()), clang_getFile(unit.get(), file.c_str())),
                   syntax.functions);
    return syntax;
}

}
