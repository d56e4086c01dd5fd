#include "core/files/netgen/netgen.hpp"

#include "core/files/common/names.hpp"
#include "core/files/common/planar_mesh.hpp"
#include "core/files/common/raise_tags.hpp"
#include "core/files/text/text_scanner.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <string>

namespace forefront {

namespace {

/// Reads a file of sections, each a name, the number of its lines, and these lines.
class NetgenReader {
  public:
    explicit NetgenReader(const SourceText &source) : scanner_(source, '#') {}

    Result<Mesh> read() {
        findSections();
        if (scanner_.ok() && places_.count("points") == 0) {
            scanner_.fail(scanner_.offset(), "bad-syntax", "the file has no points");
        }
        // The points come last in the file, but the elements refer to them.
        static_cast<void>(
            section({"points"}, &NetgenReader::point) && builder_.finishNodes(scanner_) &&
            section({"surfaceelements", "surfaceelementsgi", "surfaceelementsuv"}, &NetgenReader::element) &&
            section({"edgesegments", "edgesegmentsgi", "edgesegmentsgi2"}, &NetgenReader::edge) &&
            section({"pointelements"}, &NetgenReader::pointElement) &&
            section({"bcnames"}, &NetgenReader::boundaryName) && section({"materials"}, &NetgenReader::regionName));
        if (!scanner_.ok()) {
            return scanner_.faults();
        }
        scanner_.source().numbered(PartNumbers(1), builder_.elements.numberedFrom(1));
        builder_.findMiddles(); // segments have no middle points
        Mesh mesh = builder_.finish();
        raiseTags(mesh, scanner_.source());
        return mesh;
    }

  private:
    using Item = bool (NetgenReader::*)(TextScanner &line, std::size_t number);

    static bool isSection(std::string_view word) {
        constexpr std::string_view kSections[] = {"surfaceelements",
                                                  "surfaceelementsgi",
                                                  "surfaceelementsuv",
                                                  "volumeelements",
                                                  "edgesegments",
                                                  "edgesegmentsgi",
                                                  "edgesegmentsgi2",
                                                  "points",
                                                  "pointelements",
                                                  "bcnames",
                                                  "cd2names",
                                                  "cd3names",
                                                  "materials",
                                                  "face_colours",
                                                  "singular_points",
                                                  "singular_edge_left",
                                                  "singular_edge_right",
                                                  "singular_face_inside",
                                                  "singular_face_outside"};
        return std::find(std::begin(kSections), std::end(kSections), word) != std::end(kSections);
    }

    static bool isUsed(std::string_view word) {
        return word.starts_with("surfaceelements") || word.starts_with("edgesegments") || word == "points" ||
               word == "pointelements" || word == "bcnames" || word == "materials";
    }

    /// Notes a word that begins neither a section nor the header. The lines of unknown sections are numbers.
    void noteUnknown(const std::string &word, std::size_t place) const {
        const bool letter = (word[0] >= 'a' && word[0] <= 'z') || (word[0] >= 'A' && word[0] <= 'Z');
        if (letter && word != "mesh3d" && word != "dimension" && word != "geomtype") {
            scanner_.source().note("section", "section " + cleanName(word) + " is ignored", place);
        }
    }

    /// Notes where each section begins; skips their lines.
    void findSections() {
        TextScanner line = scanner_;
        while (scanner_.ok() && scanner_.nextLine(line)) {
            const std::size_t place = line.offset();
            const std::string word(line.word());
            if (word == "endmesh") {
                return;
            }
            if (!isSection(word)) {
                noteUnknown(word, place);
                continue;
            }
            places_[word] = scanner_.offset();
            std::size_t count = 0;
            if (!scanner_.count(count, 2, {"the number of lines"})) {
                return;
            }
            if (word == "volumeelements" && count > 0) {
                scanner_.fail(place, "not-planar", "the mesh has volume elements", "only plane meshes can be read");
                return;
            }
            if (count > 0 && !isUsed(word)) {
                scanner_.source().note("section", "section " + word + " is ignored", place);
            }
            scanner_.skipLine();
            for (std::size_t k = 0; k < count; ++k) {
                const bool found = scanner_.nextLine(line);
                const std::string first(found ? line.peek() : std::string_view());
                if (!found || isSection(first) || first == "endmesh") {
                    scanner_.fail(place, "bad-count",
                                  "the section " + word + " has " + std::to_string(k) + " lines instead of " +
                                      std::to_string(count));
                    return;
                }
            }
        }
    }

    /// Reads the lines of the first of these sections that the file has; it need not have any.
    bool section(std::initializer_list<const char *> names, Item item) {
        for (const char *name : names) {
            const auto found = places_.find(name);
            if (found == places_.end()) {
                continue;
            }
            scanner_.seek(found->second);
            std::size_t count = 0;
            if (!scanner_.count(count, 2, {"the number of lines"})) {
                return false;
            }
            scanner_.skipLine();
            TextScanner line = scanner_;
            for (std::size_t k = 0; k < count && scanner_.nextLine(line); ++k) {
                if (!(this->*item)(line, k + 1)) {
                    return scanner_.fail(line);
                }
            }
            return scanner_.ok();
        }
        return scanner_.ok();
    }

    bool point(TextScanner &line, std::size_t number) {
        return builder_.readNode(line, static_cast<std::int64_t>(number), 3);
    }

    /// Reads "surfnr bcnr domin domout np p1 p2 p3 ...": the boundary condition of a surface is the region of a plane
    /// mesh.
    bool element(TextScanner &line, std::size_t number) {
        std::int64_t surface = 0, inside = 0, outside = 0, nodes = 0;
        std::int32_t region = 1;
        const Expect what{"surface element", number};
        if (!anyInteger(line, surface, what) || !readTag(line, region, what) || !anyInteger(line, inside, what) ||
            !anyInteger(line, outside, what) || !line.integer(nodes, 1, 100, what)) {
            return false;
        }
        const std::optional<CellKind> kind = elementOfNodes(nodes);
        if (!kind) {
            return line.fail(line.offset(), "unknown-element",
                             "surface element " + std::to_string(number) + " has " + std::to_string(nodes) +
                                 " nodes; expected 3, 4, 6, 8 or 9");
        }
        return builder_.readElement(line, *kind, region, what, traitsOf(*kind).opposite);
    }

    /// Reads "surfid 0 p1 p2 ...": in a plane mesh, the first number is that of the boundary condition.
    bool edge(TextScanner &line, std::size_t number) {
        std::int32_t surface = 1;
        std::int64_t unused = 0;
        const Expect what{"edge segment", number};
        return readTag(line, surface, what) && anyInteger(line, unused, what) &&
               builder_.readEdge(line, CellKind::Edge2, surface, what);
    }

    bool pointElement(TextScanner &line, std::size_t number) {
        const Expect what{"point element", number};
        return builder_.readPoint(line, 1, what) && readTag(line, builder_.mesh.points.back().tag, what);
    }

    bool name(TextScanner &line, std::map<std::int32_t, std::string> &names, Expect what) {
        std::int32_t tag = 1;
        if (!readTag(line, tag, what)) {
            return false;
        }
        if (const std::string given = cleanName(line.rest()); !given.empty()) {
            names[tag] = given;
        }
        return true;
    }
    bool boundaryName(TextScanner &line, std::size_t number) {
        return name(line, builder_.mesh.boundaryNames, {"boundary name", number});
    }
    bool regionName(TextScanner &line, std::size_t number) {
        return name(line, builder_.mesh.regionNames, {"material", number});
    }

    static bool anyInteger(TextScanner &line, std::int64_t &value, Expect what) {
        return line.integer(value, std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max(),
                            what);
    }

    TextScanner scanner_;
    PlanarMeshBuilder builder_;
    std::map<std::string, std::size_t> places_; ///< of the counts of the sections
};

} // namespace

bool looksLikeNetgen(std::string_view head) {
    return head.starts_with("mesh3d") || head.find("\nmesh3d") != std::string_view::npos;
}

Result<Mesh> readNetgen(const SourceText &source) {
    return NetgenReader(source).read();
}

} // namespace forefront
