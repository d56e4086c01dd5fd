#pragma once

#include "core/drawing/picking/pointer_snap.hpp"
#include "core/engine/spacing/parts/expression/expression_program.hpp"
#include "ui/parts/tool.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

class CanvasPainter;
struct Workspace;

/// A pair of numbers typed as "x, y" or "@dx, dy".
struct TypedPair {
    Vec2 value;
    bool relative = false;
    std::string xText{}, yText{}; ///< the expressions typed
};

/// Parses two numbers or expressions of names separated by a comma, or two numbers separated by a space; "@" in front
/// makes them relative. The entire text must be consumed.
std::optional<TypedPair> parsePair(std::string_view text, const NamedValues &names = {},
                                   LengthUnit unit = LengthUnit::None);

/// A quantity that can be typed while drawing. Lengths in domain units, angles in degrees.
enum class EntryField : std::uint8_t { X, Y, Distance, Angle, Width, Height, Radius, Diameter, Factor };
inline constexpr std::size_t kEntryFields = 9;

/// Handles numbers typed while drawing. A digit opens the first field that the tool shows, Tab and Shift+Tab move
/// between fields, X, Y, D and Q open a field by its letter (D the diameter where a radius is asked for), and Enter
/// accepts; Ctrl+A selects the text of the open field. Typed numbers take effect immediately, so that the drawing shows
/// them before Enter. After X, a comma or Tab opens Y even if the tool shows neither, so that "x3,4" is always a point.
/// Two numbers ("3, 4" or "@1, 0") are a point. A number may be an expression of parameters, such as 2*r or, if it
/// begins with X, Y, D or Q, =d/2. Where a tool shows a single factor or angle, only that number can be typed: pairs
/// are invalid, and letters belong to its expression.
class NumericEntry {
  public:
    enum class Answer : std::uint8_t {
        Unused, ///< the event was not handled
        Used,
        Place ///< the typed numbers determine the next node: place it
    };
    /// Handles an event. `fields` are those that the tool shows now, in Tab order; X first if there is no node to
    /// measure from. `names` are the parameters that expressions may use; where there is a node to measure from, their
    /// first letters open a field too, except X, Y, D, Q and those in `ownLetters`, which mean something else to the
    /// tool. `unit`: of lengths, in which those typed in another one, such as "2 in", are converted; none: they are
    /// refused.
    Answer handle(const CanvasEvent &event, std::span<const EntryField> fields, const NamedValues &names = {},
                  std::string_view ownLetters = {}, LengthUnit unit = LengthUnit::None);

    /// Returns the value of a field, including the number being typed into it; half the diameter for a radius that was
    /// typed as such.
    std::optional<double> value(EntryField field) const;
    /// Returns the expression typed into a field; empty if there is none.
    std::string expression(EntryField field) const;
    /// Returns true if a typed expression uses parameters.
    bool usesParameters() const;
    /// Returns the values that fix coordinates, distance (or radius) and angle.
    SnapLocks locks() const;
    /// Returns the pair being typed, or the one just accepted, until clear().
    std::optional<TypedPair> pair() const;
    bool isOpen() const { return open_.has_value(); }
    /// Returns true while the text is invalid.
    bool isWrong() const { return !fault_.empty(); }
    /// Returns why the text is invalid; empty if it is valid.
    const std::string &fault() const { return fault_; }
    /// Clears all fields, after a node was placed or the drawing was cancelled.
    void clear() { *this = {}; }
    /// Returns the visible fields in one line: "width 6   height 5_". Empty if nothing is typed.
    std::string label() const;
    /// Returns what Tab and Enter do now: "Tab: y   Enter: place the centre", where `goal` is what Enter does once the
    /// numbers suffice. Empty if no field is open, or its text is invalid.
    std::string prompt(std::string_view goal) const;

  private:
    Answer key(const CanvasEvent &event);
    /// Handles a key while a field is open.
    Answer edit(const CanvasEvent &event);
    Answer text(char32_t character);
    Answer letter(EntryField field);
    Answer accept();
    void moveOn(bool back);
    bool store();
    /// Returns true if the numbers, with the one being typed, determine what is asked for.
    bool determined() const;
    bool anchored() const { return fields_.empty() || fields_.front() != EntryField::X; }
    bool shows(EntryField field) const;
    bool isScalar() const;
    bool byDiameter() const;
    std::string typedText(const std::string &stored) const;
    std::vector<EntryField> visible() const;
    std::string typedIn(EntryField field) const;
    bool continuesUnit(int letter) const;
    bool continuesExpression() const;
    bool beginsName(const CanvasEvent &event) const;
    void forget(EntryField field);
    std::optional<double> &slot(EntryField field) { return values_[static_cast<std::size_t>(field)]; }

    std::vector<EntryField> fields_;
    std::array<std::optional<double>, kEntryFields> values_;
    std::array<std::string, kEntryFields> expressions_; ///< of the values
    NamedValues names_;
    LengthUnit unit_ = LengthUnit::None;
    std::string ownLetters_;
    std::optional<EntryField> open_;
    std::string text_;
    std::string fault_;
    bool byDigit_ = false;     ///< the field was opened by a digit, so a single number may suffice
    bool nameBegins_ = false;  ///< the letter that arrives as text opens a field
    bool allSelected_ = false; ///< Ctrl+A: the next character replaces the text
    bool skipLetter_ = false;  ///< the letter that opened a field arrives as text too
};

/// Says below a typed number that its parameters are used once, if it uses any. `y`: below the place, in design pixels.
void drawUsedOnce(CanvasPainter &painter, const Workspace &context, const NumericEntry &entry, Vec2 at, double y);

} // namespace forefront
