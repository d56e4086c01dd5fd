#include "tests/fuzz/fuzz_targets.hpp"

#include "core/drawing/arrangement/repair/repair.hpp"
#include "core/drawing/document/document.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/drawing_files/script/script_player.hpp"
#include "core/drawing_files/svg/svg.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/mesh/mesh_domain.hpp"
#include "core/engine/mesh/triangulated.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/spacing/part_list.hpp"
#include "core/files/format.hpp"
#include "core/files/png/png.hpp"
#include "core/files/triangle/triangle.hpp"
#include "core/teaching/lesson/lesson_read.hpp"
#include "core/teaching/lesson_page/math_html.hpp"
#include "core/teaching/lesson_page/text_html.hpp"
#include "core/teaching/markup/marked_text.hpp"
#include "core/teaching/markup/math.hpp"
#include "tests/fuzz/byte_numbers.hpp"
#include "tests/fuzz/fuzz_checks.hpp"
#include "tests/fuzz/fuzz_runs.hpp"
#include "tests/support/png_sample.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <set>
#include <span>
#include <string>

namespace forefront::fuzz {

namespace {

SourceText sourceOf(std::string_view bytes) {
    return {bytes, "fuzz", {}, {}};
}

void checkFaults(const Diagnostics &faults) {
    demand(!faults.empty(), "a refusal says why");
    for (const Diagnostic &fault : faults) {
        demand(!fault.file.empty() && fault.line > 0 && fault.column > 0, "a fault has file, line and column");
        demand(!fault.message.empty() && !fault.code.empty(), "a fault has a message and a code");
        toString(fault);
    }
}

void checkNotes(const ImportNotes &notes) {
    for (const ImportNote &note : notes.entries()) {
        demand(note.count > 0 && note.line > 0 && note.column > 0, "a note has a count, line and column");
        demand(!note.message.empty() && !note.code.empty(), "a note has a message and a code");
    }
}

void checkDomain(const Domain &domain) {
    const auto known = [&](std::uint32_t node) { return node < domain.nodes.size(); };
    demand(std::all_of(domain.nodes.begin(), domain.nodes.end(), isFinite), "coordinates are finite");
    for (const DomainSegment &segment : domain.segments) {
        demand(known(segment.a) && known(segment.b) && segment.tag >= 1, "segments use nodes that exist");
    }
    for (const ConstraintPoint &point : domain.points) {
        demand(known(point.node) && point.tag >= 1, "points are nodes that exist");
    }
}

/// Calls a reader, checks its notes and, if it refuses the bytes, its faults.
template <class Content>
Result<Content> readWith(Result<Content> (*read)(const SourceText &), std::string_view bytes) {
    ImportNotes notes;
    SourceText source = sourceOf(bytes);
    source.notes = &notes;
    source.options.strokeAreas = bytes.size() % 2 == 1;
    source.options.shapeRegions = bytes.size() % 3 == 1;
    source.options.dropLines = bytes.size() % 5 == 1;
    source.options.layer = bytes.size() % 11 == 1 ? std::optional<std::string>("a") : std::nullopt;
    source.options.nameProperty = bytes.size() % 7 == 1 ? std::optional<std::string>("name") : std::nullopt;
    source.options.picture = PictureSizes{.black = 0.5, .white = 2.0, .box = {{0, 0}, {4, 3}}};
    auto result = read(source);
    checkNotes(notes);
    if (!result) {
        checkFaults(result.faults());
    }
    return result;
}

void checkDocument(const Document &document) {
    const std::string text = projectText(document);
    const auto again = parseProject(text, "again");
    demand(again.ok() && projectText(*again) == text, "a project survives being written and read");
}

/// Drawings and maps are arranged while they are read, so that nothing is left to repair, even in hostile ones.
void checkArranged(const Domain &domain) {
    for (const Diagnostic &fault : validate(domain)) {
        demand(!repairable(fault), "a drawing or map arrives without faults to repair");
    }
}

/// Runs all readers of a format.
void runFormat(const Format &format, std::string_view bytes) {
    const std::string_view id = format.about.id;
    if (id == "project") {
        if (const auto document = readWith(readProjectText, bytes)) {
            checkDocument(*document);
        }
    } else if (format.readDomain != nullptr) {
        if (const auto file = readWith(format.readDomain, bytes)) {
            checkDomain(file->domain);
            demand(checkSpacing(file->spacing, file->domain).empty(), "the sizes of a file are valid");
            if (format.about.arranges) {
                checkArranged(file->domain);
            }
        }
    }
    if (id == "svg") { // the clipboard reads drawings as shapes
        if (const auto shapes = readWith(readSvgShapes, bytes)) {
            checkDomain(*shapes);
            checkDocument(fromDomain(*shapes));
        }
    }
    if (format.readMesh != nullptr) {
        if (const auto mesh = readWith(format.readMesh, bytes)) {
            checkMesh(*mesh);
            checkMesh(triangulated(*mesh).mesh);
            static_cast<void>(verify(*mesh));
            if (const auto outline = domainOfMesh(*mesh)) {
                checkDomain(outline->domain);
            }
        }
    }
    if (format.readSpacing != nullptr) {
        static_cast<void>(readWith(format.readSpacing, bytes));
    }
}

bool sameReaders(const Format &a, const Format &b) {
    return a.readDomain == b.readDomain && a.readMesh == b.readMesh && a.readSpacing == b.readSpacing;
}

/// Corrects the check sums of the chunks, so that changed bytes reach the decoder.
std::string withCheckSums(std::string_view bytes) {
    std::string file(bytes);
    for (std::size_t at = 8; at + 12 <= file.size();) {
        std::size_t length = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            length = length << 8 | static_cast<unsigned char>(file[at + k]);
        }
        if (length > file.size() - at - 12) {
            break;
        }
        const std::uint32_t sum = testing::pngSum(std::string_view(file).substr(at + 4, length + 4));
        for (std::size_t k = 0; k < 4; ++k) {
            file[at + 8 + length + k] = static_cast<char>(sum >> (24 - 8 * k) & 0xFFU);
        }
        at += length + 12;
    }
    return file;
}

void runPng(const Format &format, std::string_view bytes) {
    runFormat(format, bytes);
    runFormat(format, withCheckSums(bytes));
}

/// Nodes, elements and edges in one input, separated by lines "%%".
void runTriangle(std::string_view bytes) {
    constexpr std::string_view kCut = "%%\n";
    const std::size_t first = std::min(bytes.find(kCut), bytes.size());
    const std::string_view rest = bytes.substr(std::min(first + kCut.size(), bytes.size()));
    const std::size_t second = std::min(rest.find(kCut), rest.size());
    const SourceText edges = sourceOf(rest.substr(std::min(second + kCut.size(), rest.size())));
    const auto result = readTriangleParts(sourceOf(bytes.substr(0, first)), sourceOf(rest.substr(0, second)),
                                          edges.text.empty() ? nullptr : &edges);
    if (result) {
        checkMesh(*result);
    } else {
        checkFaults(result.faults());
    }
}

Domain domainFrom(ByteNumbers &numbers) {
    Domain domain;
    domain.insideRule = numbers.byte() % 2 == 0 ? InsideRule::EvenOdd : InsideRule::HoleMarkers;
    const unsigned nodes = 1 + numbers.byte() % 64;
    for (unsigned n = 0; n < nodes; ++n) {
        const double x = numbers.coordinate();
        domain.nodes.push_back({x, numbers.coordinate()});
    }
    while (!numbers.atEnd()) {
        const unsigned kind = numbers.byte(), a = numbers.byte() % nodes, b = numbers.byte() % nodes;
        if (kind % 8 == 7) {
            domain.points.push_back({a, 1});
        } else {
            const SegmentRole role = kind % 8 < 5 ? SegmentRole::Boundary : SegmentRole::Constraint;
            domain.segments.push_back({a, b, static_cast<std::int32_t>(1 + kind / 8), role});
        }
    }
    return domain;
}

void checkRepair(const Domain &domain, double tolerance) {
    const auto once = repair(domain, tolerance);
    if (!once) {
        demand(!once.faults().front().message.empty(), "a refusal says why");
        return;
    }
    checkDomain(once->domain);
    bool outOfRange = false; // such as one edge as long as a unit of the last place, which is all that is left
    for (const Diagnostic &fault : validate(once->domain)) {
        demand(domain.insideRule == InsideRule::HoleMarkers || !repairable(fault), "a repair leaves nothing to repair");
        outOfRange = outOfRange || fault.code == "out-of-range";
    }
    constexpr double kSlack = 1.0 + 1e-9; // rounding adds to a distance
    for (const ArrangementChange &change : once->changes) {
        demand(change.displacement <= std::max(kSlack * tolerance, 1e-9), "nothing moves farther than the tolerance");
    }
    const auto twice = repair(once->domain, once->radius);
    if (outOfRange) {
        demand(!twice.ok() && twice.faults().front().code == "out-of-range", "what is left is refused for its extent");
        return;
    }
    demand(twice.ok() && twice->changes.empty() && twice->domain.nodes == once->domain.nodes,
           "a second repair changes nothing");
}

/// Reads the bytes as a domain: its nodes, then segments and points between them.
void runRepair(std::string_view bytes) {
    ByteNumbers numbers(bytes);
    const Domain domain = domainFrom(numbers);
    checkRepair(domain, 0.0);
    checkRepair(domain, 0.25);
}

/// Returns true if as many spans of a text of HTML end as begin.
bool balanced(std::string_view html) {
    std::size_t open = 0, closed = 0;
    for (std::size_t at = html.find('<'); at != std::string_view::npos; at = html.find('<', at + 1)) {
        open += html.substr(at).starts_with("<span") ? 1U : 0U;
        closed += html.substr(at).starts_with("</span>") ? 1U : 0U;
    }
    return open == closed;
}

/// Reads bytes as a formula, and sets it.
void runMath(std::string_view bytes) {
    const Result<MathNode> formula = parseMath(bytes);
    if (!formula) {
        demand(!formula.faults().empty(), "a refusal says why");
        for (const Diagnostic &fault : formula.faults()) {
            demand(fault.column > 0 && static_cast<std::size_t>(fault.column) <= bytes.size() + 1,
                   "a fault is at a place in the formula");
        }
        return;
    }
    demand(balanced(mathHtml(*formula, true)), "each element of HTML is closed");
    std::string pieces;
    for (const MathNode &piece : brokenMath(*formula)) {
        pieces += mathHtml(piece, false);
    }
    demand(!pieces.empty() || formula->parts.empty(), "the pieces of a formula hold all of it");
}

void runLesson(std::string_view bytes) {
    const auto lesson = readLesson(sourceOf(bytes), {});
    if (!lesson) {
        checkFaults(lesson.faults());
        return;
    }
    demand(!lesson->pages.empty(), "a lesson has pages");
    const SessionSnapshot run;
    for (const LessonPage &page : lesson->pages) {
        for (const std::string &paragraph : page.paragraphs) {
            const std::string shown = withValues(paragraph, {run});
            demand(!shown.empty(), "a paragraph has a text");
            demand(parseMarkup(paragraph).ok(), "the markup of a paragraph has been checked");
            demand(parseMarkup(shown).ok(), "values in a paragraph leave its markup whole");
            demand(balanced(TextHtml(*lesson).of(shown)), "each element of HTML is closed");
        }
        if (page.question) {
            demand(!page.question->text.empty(), "a question has a text");
        }
    }
}

/// Plays the commands of a script that edit a drawing.
void runScript(std::string_view bytes) {
    const SourceText source = sourceOf(bytes);
    const auto script = Script::read(source);
    if (!script) {
        checkFaults(script.faults());
        return;
    }
    ScriptPlayer player;
    for (const ScriptCommand &command : script->commands()) {
        if (!editsDocument(command.word)) {
            continue;
        }
        if (const Status faults = player.play(command, source); !faults.empty()) {
            checkFaults(faults);
        }
    }
    checkDocument(player.document());
}

/// Returns true for formats that another library parses, of which only its result reaches our readers.
bool parsedElsewhere(const FileFormat &format) {
    return *format.component != '\0' && format.kind != FileKind::Mesh;
}

/// Lists one target for each format that has its own readers. Triangle's files share one input, since the reader
/// looks for the others only beside the file that it reads.
std::vector<Target> listTargets() {
    std::vector<Target> list;
    for (const Format &format : allFormats().formats()) {
        const auto same = [&](const Target &target) { return sameReaders(*target.format, format); };
        const bool reads = format.canReadDomain() || format.readSpacing != nullptr;
        if (reads && !parsedElsewhere(format.about) && std::none_of(list.begin(), list.end(), same)) {
            list.push_back({format.about.id, &format});
        }
    }
    list.push_back({"lesson", nullptr, runLesson});
    list.push_back({"math", nullptr, runMath});
    list.push_back({"script", nullptr, runScript});
    list.push_back({"repair", nullptr, runRepair});
    constexpr std::size_t kRuns = 300; // a mesh takes longer than a file
    list.push_back({"mesh", nullptr, runMesh, kRuns});
    list.push_back({"run", nullptr, runProject, kRuns});
    return list;
}

} // namespace

void Target::run(std::string_view bytes) const {
    if (format == nullptr) {
        runOther(bytes);
    } else if (format->readMesh == readTriangle) {
        runTriangle(bytes);
    } else if (format->readSpacing == readPngSpacing) {
        runPng(*format, bytes);
    } else {
        runFormat(*format, bytes);
    }
}

const std::vector<Target> &targets() {
    static const std::vector<Target> list = listTargets();
    return list;
}

const Target *find(std::string_view name) {
    const auto &list = targets();
    const auto found =
        std::find_if(list.begin(), list.end(), [&](const Target &target) { return name == target.name; });
    return found != list.end() ? &*found : nullptr;
}

} // namespace forefront::fuzz
