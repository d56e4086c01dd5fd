#pragma once

#include "core/drawing/names/name_commands.hpp"
#include "ui/input/pixels.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

class DocumentStore;
struct Shell;

/// Something that can be given a name.
struct NamedThing {
    enum class Kind : std::uint8_t {
        Shape,  ///< `shape`
        Tag,    ///< boundary tag `tag`, wherever it is used
        Part,   ///< `part` of the boundary; other parts keep their tags
        Region, ///< of region marker `marker`
        Source  ///< size source `source`
    };
    Kind kind = Kind::Shape;
    std::uint32_t shape = 0; ///< Shape::id
    std::int32_t tag = 0;    ///< of Kind::Part: the tag of its first segment
    std::uint32_t marker = 0;
    std::uint32_t source = 0; ///< index in SpacingSpec::sources
    BoundaryPart part{};

    /// Returns true for the same item, even if it has been renamed.
    bool same(const NamedThing &other) const {
        return kind == other.kind && shape == other.shape && tag == other.tag && marker == other.marker &&
               source == other.source;
    }
    /// Returns false once it was deleted, or has another tag.
    bool existsIn(const Document &document) const;
    /// Returns the name that is edited; for a shape without a name, an empty text.
    std::string name(const Document &document) const;
    /// Describes the named item, such as "Boundary tag of 3 segments".
    std::string title(const Document &document) const;
    /// Returns the names that others of its kind have, without repetitions.
    std::vector<std::string> choices(const Document &document) const;
    /// Returns the document in which it has another name.
    Result<Document> renamed(const Document &document, const std::string &name) const;
};

/// The field in which something is named: in a row of the Shapes panel, or on the canvas.
struct Naming {
    std::optional<NamedThing> thing; ///< while its field is open
    std::optional<NamedThing> other; ///< what a switch in the field on the canvas offers to name in its place
    bool inPanel = false;
    Pixel at{};                 ///< of the field on the canvas
    std::uint64_t revision = 0; ///< of the document when that was opened
    int frames = 0;             ///< that the field was drawn
    std::string text;           ///< typed on the canvas
    std::string fault;          ///< why the text was refused
    int choice = -1;            ///< index of the name chosen with the arrow keys; -1: the text
    bool edited = false;        ///< the text was changed
    bool everywhere = false;    ///< also other parts with the tag get the name

    /// The row of the panel that was clicked last, until the canvas is clicked or the row is gone; F2 renames it.
    std::optional<NamedThing> row;
    int rowFrame = -1; ///< in which the panel was drawn last

    void openInPanel(NamedThing what);
    /// `label`: its label on the canvas was clicked, which means all parts with the name.
    void openOnCanvas(NamedThing what, Pixel place, const DocumentStore &store, bool label = false);
    /// Names the other thing in the field on the canvas; a text that was typed stays.
    void swapThings(const Document &document);
    void close() { thing.reset(); }
};

/// Gives the thing a name, as one step of the history.
void applyName(Shell &context, const NamedThing &thing, const std::string &name);
/// Returns the item of a selection that F2 renames: the boundary part of segments and shapes, a region or a size
/// source; of a single shape with several boundary parts the shape.
std::optional<NamedThing> namedThing(const Document &document, const Selection &selection);
/// Returns what the field for `thing` offers to name in its place: of a single selected shape its boundary part or the
/// shape itself; otherwise nothing.
std::optional<NamedThing> otherThing(const Document &document, const Selection &selection, const NamedThing &thing);
/// Returns the boundary part or region whose label is at a pixel of the canvas.
std::optional<NamedThing> labelAt(const Shell &context, Pixel pixel);
/// Returns a selection of the named item, as far as it can be selected.
Selection selectionOf(const Document &document, const NamedThing &thing);
/// Returns the boundary part of a selection; nothing if no segments are selected.
std::optional<NamedThing> boundaryPartOf(const Document &document, const Selection &selection);

} // namespace forefront
