#pragma once

#include "ui/canvas/camera.hpp"
#include "ui/gl/split.hpp"
#include "ui/style/colour.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

class GlKit;

/// The style in which a batch of segments is drawn; lengths in pixels.
struct LineStyle {
    double width = 1.5;
    double arrow = 0.0; ///< size of an arrowhead in the middle of segments that are long enough
};

/// A batch of thick anti-aliased segments with round ends, one instanced quad each. A segment of zero length is a dot.
class LineBatch {
  public:
    LineBatch();
    ~LineBatch();
    LineBatch(const LineBatch &) = delete;
    LineBatch &operator=(const LineBatch &) = delete;

    void clear() { segments_.clear(), dirty_ = true; }
    void add(Vec2 a, Vec2 b, Colour colour);
    std::size_t size() const { return segments_.size(); }
    void draw(GlKit &gl, const Camera &camera, const LineStyle &style);

  private:
    struct Segment {
        SplitPoint a, b;
        Colour colour;
    };

    std::vector<Segment> segments_;
    unsigned array_ = 0, buffer_ = 0;
    bool dirty_ = false;
};

/// A batch of axis-parallel boxes, filled and framed.
class BoxBatch {
  public:
    BoxBatch();
    ~BoxBatch();
    BoxBatch(const BoxBatch &) = delete;
    BoxBatch &operator=(const BoxBatch &) = delete;

    void clear() { boxes_.clear(), dirty_ = true; }
    void add(const Box2 &box, Colour fill, Colour frame);
    /// `frameWidth` in pixels.
    void draw(GlKit &gl, const Camera &camera, double frameWidth);

  private:
    struct Box {
        SplitPoint min, max;
        Colour fill, frame;
    };

    std::vector<Box> boxes_;
    unsigned array_ = 0, buffer_ = 0;
    bool dirty_ = false;
};

} // namespace forefront
