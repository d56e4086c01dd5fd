#include "core/engine/base/letter_case.hpp"
#include "core/files/common/names.hpp"
#include "core/files/common/part_groups.hpp"
#include "core/files/common/planar_mesh.hpp"
#include "core/files/common/raise_tags.hpp"
#include "core/files/nastran/nastran.hpp"
#include "core/files/nastran/nastran_cards.hpp"
#include "core/files/nastran/nastran_real.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr std::int64_t kMaxNumber = std::numeric_limits<std::int32_t>::max();

/// An element card: its kind, and whether a field with the property comes before its nodes.
struct ElementCard {
    std::string_view name;
    CellKind kind;
    bool hasProperty = true;
};

constexpr std::array kElementCards = {
    ElementCard{"CTRIA3", CellKind::Triangle3},      ElementCard{"CTRIAR", CellKind::Triangle3},
    ElementCard{"CTRIA6", CellKind::Triangle6},      ElementCard{"CQUAD4", CellKind::Quadrilateral4},
    ElementCard{"CQUADR", CellKind::Quadrilateral4}, ElementCard{"CSHEAR", CellKind::Quadrilateral4},
    ElementCard{"CQUAD8", CellKind::Quadrilateral8}, ElementCard{"CROD", CellKind::Edge2},
    ElementCard{"CTUBE", CellKind::Edge2},           ElementCard{"CBAR", CellKind::Edge2},
    ElementCard{"CBEAM", CellKind::Edge2},           ElementCard{"PLOTEL", CellKind::Edge2, false},
};

/// Elements that no plane mesh has, or that lie in another plane.
constexpr std::array<std::string_view, 9> kOtherElements = {"CTETRA", "CHEXA",   "CPENTA", "CPYRAM", "CQUAD",
                                                            "CQUADX", "CTRIAX6", "CTRIAX", "CQUAD9"};

class NastranReader {
  public:
    explicit NastranReader(const SourceText &source) : scanner_(source), cards_(source.text) {}

    Result<Mesh> read() {
        origins_ = readGroupOrigins(scanner_.source().text, "$");
        NastranCard card;
        while (scanner_.ok() && cards_.next(card) && scanner_.proceed(card.offset)) {
            if (!card.fault.empty()) {
                scanner_.fail(card.offset, "bad-syntax", card.fault, card.advice);
            } else {
                read(card);
            }
        }
        if (scanner_.ok() && builder_.mesh.nodes.empty()) {
            scanner_.fail(scanner_.offset(), "bad-syntax", "the file has no GRID cards");
        }
        if (!builder_.finishNodes(scanner_) || !resolve()) {
            return scanner_.faults();
        }
        builder_.readPointComments(scanner_, "$");
        scanner_.source().numbered(PartNumbers(builder_.table.numbers()), builder_.elements.numbered(numbers_));
        builder_.findMiddles(); // rods join the ends of edges
        Mesh mesh = builder_.finish();
        for (const auto &[number, group] : origins_) {
            addName(group.dimension == 2 ? mesh.regionNames : mesh.boundaryNames, group.tag, group.name,
                    group.dimension == 2);
        }
        raiseTags(mesh, scanner_.source());
        return mesh;
    }

  private:
    struct Cell {
        CellKind kind;
        std::int32_t tag;
        std::int64_t number;
        std::size_t offset;
        std::array<std::int64_t, 8> nodes;
    };

    void read(const NastranCard &card) {
        const SourceText &source = scanner_.source();
        const auto element = std::find_if(kElementCards.begin(), kElementCards.end(),
                                          [&](const ElementCard &each) { return each.name == card.name; });
        if (card.name == "GRID") {
            gridPoint(card);
        } else if (element != kElementCards.end()) {
            cell(card, *element);
        } else if (std::find(kOtherElements.begin(), kOtherElements.end(), card.name) != kOtherElements.end()) {
            scanner_.fail(card.offset, "unknown-element",
                          "elements " + card.name +
                              " cannot be read; only CTRIA3, CTRIA6, CTRIAR, CQUAD4, CQUAD8, CQUADR, CSHEAR, CROD, "
                              "CTUBE, CBAR, CBEAM and PLOTEL");
        } else if (card.name == "INCLUDE") {
            scanner_.fail(card.offset, "unknown-section", "included files are not read",
                          "put their lines in the place of the card");
        } else if (card.name == "GRDSET") {
            scanner_.fail(card.offset, "coordinate-system", "defaults of grid points (GRDSET) cannot be read",
                          "write their values on each GRID card");
        } else {
            source.note("card", "card " + inQuotes(card.name) + " is ignored", card.offset);
        }
    }

    bool integer(const NastranCard &card, std::size_t field, std::int64_t &value, Expect what) {
        const std::string_view text = scanner_.source().text;
        const auto [begin, end] = card.field(field);
        TextScanner part = scanner_.part(begin, end);
        if (begin == end) {
            return scanner_.fail(card.offset, "bad-number",
                                 "expected an integer for " + what.words() + ", field " + std::to_string(field + 2) +
                                     " is empty");
        }
        if (!part.integer(value, 0, kMaxNumber, what)) {
            return scanner_.fail(part);
        }
        return part.atEnd() || scanner_.fail(begin, "bad-number",
                                             "expected an integer for " + what.words() + ", found " +
                                                 inQuotes(text.substr(begin, end - begin)));
    }

    bool real(const NastranCard &card, std::size_t field, double &value, Expect what) {
        const auto [begin, end] = card.field(field);
        if (begin == end) {
            value = 0.0; // as Nastran takes it
            return true;
        }
        const std::string_view text = scanner_.source().text.substr(begin, end - begin);
        const std::optional<double> number = readNastranReal(text);
        if (!number) {
            return scanner_.fail(begin, "bad-number",
                                 "expected a number for " + what.words() + ", found " + inQuotes(text));
        }
        value = *number;
        return std::isfinite(value) ||
               scanner_.fail(begin, "non-finite", what.words() + " must be finite, found " + inQuotes(text));
    }

    /// GRID: number, coordinate system, x, y, z.
    void gridPoint(const NastranCard &card) {
        std::int64_t number = 0, system = 0;
        if (!integer(card, 0, number, {"the number of a grid point"})) {
            return;
        }
        if (!card.isEmpty(1) && !integer(card, 1, system, {"the coordinate system of a grid point"})) {
            return;
        }
        if (system != 0) {
            scanner_.fail(card.offset, "coordinate-system",
                          "grid point " + std::to_string(number) + " is in the coordinate system " +
                              std::to_string(system) + "; expected basic coordinates",
                          "write the grid points in basic coordinates");
            return;
        }
        const Expect what{"the coordinates of grid point", static_cast<std::uint64_t>(number)};
        Vec2 place;
        double z = 0.0;
        if (real(card, 2, place.x, what) && real(card, 3, place.y, what) && real(card, 4, z, what)) {
            builder_.noteHeight(z, card.offset);
            builder_.mesh.nodes.push_back(place);
            builder_.table.add(number);
        }
    }

    void cell(const NastranCard &card, const ElementCard &element) {
        Cell cell{element.kind, 1, 0, card.offset, {}};
        std::int64_t property = 1;
        if (!integer(card, 0, cell.number, {"the number of an element"})) {
            return;
        }
        const Expect what{"element", static_cast<std::uint64_t>(cell.number)};
        if (element.hasProperty) {
            property = cell.number; // as Nastran takes it
            if (!card.isEmpty(1) && !integer(card, 1, property, {"the property of element", what.number})) {
                return;
            }
        }
        const std::size_t first = element.hasProperty ? 2 : 1;
        const CellTraits &traits = traitsOf(element.kind);
        if (traits.order == 2 && middlesAreEmpty(card, first, traits)) {
            cell.kind = traits.corners == 3 ? CellKind::Triangle3 : CellKind::Quadrilateral4;
        }
        for (std::size_t k = 0; k < traitsOf(cell.kind).nodes; ++k) {
            if (!integer(card, first + k, cell.nodes[k], what)) {
                return;
            }
        }
        const auto origin = origins_.find(static_cast<std::int32_t>(property));
        cell.tag = origin != origins_.end() ? origin->second.tag : static_cast<std::int32_t>(property);
        cells_.push_back(cell);
    }

    /// Nastran allows to leave out the middle nodes of an element.
    static bool middlesAreEmpty(const NastranCard &card, std::size_t first, const CellTraits &traits) {
        for (std::size_t k = traits.corners; k < traits.nodes; ++k) {
            if (!card.isEmpty(first + k)) {
                return false;
            }
        }
        return true;
    }

    bool resolve() {
        for (const Cell &cell : cells_) {
            const CellTraits &traits = traitsOf(cell.kind);
            const Expect expect{"element", static_cast<std::uint64_t>(cell.number)};
            std::array<NodeId, kMaxCellNodes> nodes{};
            for (std::size_t k = 0; k < traits.nodes; ++k) {
                const std::uint32_t found = builder_.table.find(cell.nodes[k]);
                if (found == kNoIndex) {
                    return scanner_.fail(cell.offset, "bad-index",
                                         expect.words() + " refers to grid point " + std::to_string(cell.nodes[k]) +
                                             ", which does not exist");
                }
                nodes[k] = NodeId{found};
            }
            const std::span<const NodeId> all = std::span(nodes).first(traits.nodes);
            if (!requireDistinct(scanner_, cell.offset, all, expect)) {
                return false;
            }
            builder_.addCell(cell.kind, all, cell.tag);
            if (traits.dimension == 2) {
                numbers_.push_back(cell.number);
            }
        }
        return true;
    }

    TextScanner scanner_;
    NastranCards cards_;
    PlanarMeshBuilder builder_;
    std::vector<Cell> cells_;
    std::vector<std::int64_t> numbers_;
    std::map<std::int32_t, PartGroup> origins_;
};

} // namespace

bool looksLikeNastran(std::string_view head) {
    const std::string text = upperCase(std::string(head));
    if (text.find("BEGIN BULK") != std::string::npos) {
        return true;
    }
    for (std::size_t at = text.find("GRID"); at != std::string::npos; at = text.find("GRID", at + 1)) {
        const bool begins = at == 0 || text[at - 1] == '\n';
        if (begins && at + 4 < text.size() && std::string_view(" *,").find(text[at + 4]) != std::string_view::npos) {
            return true;
        }
    }
    return false;
}

Result<Mesh> readNastran(const SourceText &source) {
    return NastranReader(source).read();
}

} // namespace forefront
