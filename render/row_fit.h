#pragma once

#include <span>
#include <vector>

#include "render/visible_shadow.h"

namespace seaway::render {

/// Ends of a grid's rows, straight lines across at `along` m from the foot point, growing, so that
/// the quadrilaterals between neighbours cover all of the shadow from the first row to the last,
/// and little more. In place of the thesis' rectangle in projector space: its "future work".
///
/// `sight`: distance of each row from the projector, m, > 0. No row is narrower than a twentieth of
/// what the widest is at its distance, so that no column is much denser than others and none has no
/// width. Rows that see nothing are as their neighbours.
std::vector<VisibleShadow::Interval> fittedRows(const VisibleShadow& shadow,
                                                std::span<const double> along,
                                                std::span<const double> sight);

}  // namespace seaway::render
