#pragma once

#include <imgui.h>

#include <cstddef>
#include <span>
#include <utility>

struct ImGuiInputTextState;

/// Everything that differs between the versions of Dear ImGui, 1.86 in Debian 12 and 1.91.4 to 1.92. Keys are those of
/// `ui/input/keys.hpp`.
namespace forefront::imgui {

/// Returns the height of a line of a font, in pixels.
float lineOf(const ImFont &font);
/// Returns true if a font has a character itself, rather than a replacement.
bool holds(ImFont &font, unsigned code);

/// Chooses FreeType with light hinting for an empty atlas.
void useFreeType(ImFontAtlas &atlas);
/// Reserves a square of `size` pixels for a character of a font whose lines are `line` pixels high, `top` below the top
/// of a line. Returns its number for drawInto().
int reserveGlyph(ImFontAtlas &atlas, ImFont &font, float line, unsigned code, int size, float top);
/// Builds the atlas.
void build(ImFontAtlas &atlas);
/// Draws a reserved square of a built atlas: `cover` has a byte per pixel, row by row.
void drawInto(ImFontAtlas &atlas, int number, std::span<const unsigned char> cover);
/// Gives characters the width of the widest and centres them in it.
void makeTabular(ImFont &font, unsigned first, unsigned last);
/// The ink of a character of a font, from the top of its line, and how far the next one is, in pixels.
struct GlyphInk {
    float top = 0.0F, bottom = 0.0F, advance = 0.0F;
};
/// Returns the ink of a character, or of what stands for one that the font lacks.
GlyphInk inkOf(ImFont &font, unsigned code);
/// Returns the height of the baseline of a font below the top of its line, in pixels.
float baselineOf(ImFont &font);
/// Draws a texture of OpenGL over a rectangle.
void drawTexture(ImDrawList &list, unsigned texture, ImVec2 min, ImVec2 max);
/// Gives the built atlas to the graphics card, in place of the one before.
void uploadFonts();

/// Tells Dear ImGui the keys that it uses itself.
void mapKeys();
/// Passes on a key. A repeated one counts as pressed anew.
void feedKey(int code, bool pressed, bool repeated);
/// Releases all keys.
void releaseKeys();
/// Lets Enter run the chosen item of an open menu.
void feedEnterToMenu();
bool keyPressed(int code, bool repeats = true);
bool keyHeld(int code);

/// While it lives, Ctrl+Shift+Z redoes in text fields. Version 1.86 knows only Ctrl+Y, so Z is shown to it as Y.
class RedoByShiftZ {
  public:
    RedoByShiftZ();
    ~RedoByShiftZ();
    RedoByShiftZ(const RedoByShiftZ &) = delete;
    RedoByShiftZ &operator=(const RedoByShiftZ &) = delete;

  private:
    bool swapped_;
};

/// Returns the selected part of the text of a field, in bytes from its beginning.
std::pair<std::size_t, std::size_t> selectedBytes(const ImGuiInputTextState &field);

/// Draws text up to `right`, with an ellipsis if it is longer. `size`: of the whole text.
void textUpTo(ImVec2 corner, float right, const char *begin, const char *end, ImVec2 size);

/// Highlights an item of the current window, as the arrow keys do. `min`, `max`: its rectangle relative to the window.
void highlightItem(ImGuiID id, ImVec2 min, ImVec2 max);
/// Returns true if the arrow keys have highlighted an item.
bool anyHighlight();

} // namespace forefront::imgui
