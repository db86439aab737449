// The scales of one sequence of covers of certified_bars.hpp, and the levels of cells in it.
#pragma once
#include "jobs/bar_bounds.hpp"
#include "jobs/value_table.hpp"
#include "memory/arena.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

// Around a scale b: least <= b <= most, and each cell with hi <= most has lo <= least. From b to most it has several
// ends.
struct CoverWindow {
    static constexpr int ends = 5;

    double least, most;
};

// The scales b_0 < b_1 < ... of a sequence of covers.
class CoverSequence {
public:
    static constexpr int scales_max = 96;
    // By the spacing, as a factor or a quarter of its difference: between scales where no cell lies across; between
    // ends of a window.
    static constexpr double stride = 1.25, between_ends = 1.125;

    explicit CoverSequence(Spacing spacing) : spacing_(spacing) {}
    Status open(const FilterBounds& filter, Arena& arena);
    // A sequence through scale s.
    void go_through(double s, const FilterBounds& filter, const Arena& arena);
    int scales() const { return scales_; }
    // -1: before all births, scales(): after all finite deaths; of a function of any sign where its values begin and
    // end.
    double scale(int i) const {
        if (i < 0) return spacing_.is_difference() ? by_low_.first() : 0;
        return i < scales_ ? scale_[i] : spacing_.is_difference() ? by_high_.last() : infinity;
    }
    // Of each scale the levels are X_i, X at the other ends of its window, Y where that begins, Y_i.
    static constexpr int levels = CoverWindow::ends + 2;
    // In nothing before this one.
    int level(const Interval& cell) const {
        const int y = scales_until(cell.lo);
        if (y == scales_) return levels * scales_;
        const int k = end_from(y, cell.hi);
        return levels * y + k + (k == CoverWindow::ends && cell.lo > window_[y].least ? 1 : 0);
    }
    double window_begin(int i) const { return window_[i].least; }
    // The first end of window i that is not before x; CoverWindow::ends for none.
    int end_from(int i, double x) const {
        if (x > window_[i].most) return CoverWindow::ends;
        int k = 0;
        for (double end = scale_[i]; k < CoverWindow::ends - 1 && x > end; ++k) end = spacing_.after(end, between_ends);
        return k;
    }

private:
    // How many scales are before x.
    int scales_until(double x) const {
        int y = 0;
        while (y < scales_ && scale_[y] < x) ++y;
        return y;
    }
    void find_windows(const FilterBounds& filter, const Arena& arena);

    ValueTable by_low_, by_high_;  // largest hi up to a lo, least lo from a hi on
    double scale_[scales_max];
    CoverWindow* window_ = nullptr;  // [scales_max]
    int scales_ = 0;
    Spacing spacing_;
};

}  // namespace netmesh
