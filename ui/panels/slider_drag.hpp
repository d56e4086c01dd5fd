#pragma once

namespace forefront {

struct Shell;

/// The drag of a slider that edits the document: it is one undo step, and Esc takes it back.
class SliderDrag {
  public:
    /// `stroke` names the drags, see DocumentStore::apply().
    explicit SliderDrag(const char *stroke) : stroke_(stroke) {}

    /// Call once per frame, after the slider is drawn. `apply(stroke)` makes the change that the slider asks for, and
    /// returns false if there is none; it is called if `moved`.
    template <class Apply>
    void follow(Shell &context, bool moved, const Apply &apply) {
        const bool released = begin(context);
        if (moved && !cancelled_ && apply(stroke_)) {
            dragged_ = true;
        }
        end(context, released);
    }

  private:
    /// Takes the drag back if Esc is pressed. Returns true if the button is up.
    bool begin(Shell &context);
    void end(Shell &context, bool released);

    const char *stroke_;
    bool dragged_ = false;   ///< the slider has changed the document, and the button is still down
    bool cancelled_ = false; ///< Esc was pressed; the button is still down
};

} // namespace forefront
