#pragma once

namespace forefront {

/// The targets that the tools snap to.
struct Snapping {
    bool toDrawing = true;        ///< nodes and segments
    bool toGrid = true;           ///< the drawing lattice
    bool toGuides = true;         ///< the guides of the document
    bool infers = true;           ///< relations to other lines and nodes, see inferRelations()
    bool addsConstraints = false; ///< relations that are taken become constraints
    bool offForPicture = false;   ///< toGrid was switched off when a background picture was added
    double gridStep = 0.0;        ///< of the grid, domain units; 0: it follows the zoom
    double reach = 9.0;           ///< design pixels
    double angleStep = 15.0;      ///< of directions with Shift, degrees
    friend bool operator==(const Snapping &, const Snapping &) = default;
};

} // namespace forefront
