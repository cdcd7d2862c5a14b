#include "surface/disturbance/wake_window.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "surface/constants.h"
#include "surface/disturbance/wake_kernels.h"
#include "surface/disturbance/wake_output.h"
#include "surface/state_archive.h"

namespace seaway {
namespace {

/// The border's mask is cos^(2P): 2P + 1 taps in Fourier space.
constexpr int borderPower = 12;

/// A length as a fraction of the window's size, [0, 1): phases of any place keep all their digits.
double fractionOf(double length, double size) {
  const double turns = length / size;
  return turns - std::floor(turns);
}

/// Fourier coefficients q = 0 … P of 1 − a cos^(2P)(πx/L): δ_q0 − a 4^(−P) C(2P, P + q).
std::vector<float> borderTaps(double a) {
  std::vector<float> taps(borderPower + 1);
  double binomial = 1.0;  // 4^(−P) C(2P, P + q)
  for (int i = 1; i <= borderPower; ++i) binomial *= (borderPower + i) / (4.0 * i);
  for (int q = 0; q <= borderPower; ++q) {
    taps[q] = static_cast<float>((q == 0 ? 1.0 : 0.0) - a * binomial);
    binomial *= static_cast<double>(borderPower - q) / (borderPower + q + 1);
  }
  return taps;
}

}  // namespace

/// e^(−2πi m turns) for the columns' m = −modes/2 … modes/2 − 1, and for rows by their m.
struct WakeWindow::AxisPhases {
  AxisPhases(int modes, double turns) : half(modes / 2), real(modes + 16), imaginary(modes + 16) {
    for (int c = 0; c < modes; ++c) {
      const double angle = 2.0 * pi * std::remainder((c - half) * turns, 1.0);
      real[c] = static_cast<float>(std::cos(angle));
      imaginary[c] = static_cast<float>(-std::sin(angle));
    }
  }
  wake::Columns columns() const { return {real.data(), imaginary.data()}; }
  std::complex<float> at(int m) const { return {real[m + half], imaginary[m + half]}; }

  int half;
  std::vector<float> real, imaginary;
};

WakeWindow::WakeWindow(std::shared_ptr<const WakeTables> tables,
                       std::shared_ptr<const FootprintTable> hull)
    : tables_(std::move(tables)),
      hull_(std::move(hull)),
      real_(settings().modes, static_cast<std::size_t>(settings().modes)),
      imaginary_(real_),
      footprintReal_(real_),
      footprintImaginary_(real_),
      footprintHeading_(std::numeric_limits<double>::quiet_NaN()),
      fft_(static_cast<std::size_t>(settings().cells)) {
  check(settings());
}

double WakeWindow::largestWaveNumber(const WakeWindowSettings& settings) {
  return 2.0 * pi / settings.band.shortNone;
}

std::size_t WakeWindow::rowOf(int my) const {
  return static_cast<std::size_t>(my >= 0 ? my : my + settings().modes);
}

template <class Visit>
void WakeWindow::forEachMode(Visit visit) const {
  const int half = settings().modes / 2;
  for (int my = 1 - half; my < half; ++my) {
    const std::size_t shared = static_cast<std::size_t>(std::abs(my)), row = rowOf(my);
    for (int c = tables_->begin[shared]; c < tables_->end[shared]; ++c) visit(c, my, shared, row);
  }
}

void WakeWindow::turnFootprint(const HullPlace& place) {
  // The same heading again, as on a straight course, is not looked up again.
  if (place.heading == footprintHeading_) return;
  footprintHeading_ = place.heading;
  const int half = settings().modes / 2;
  const double unit = 2.0 * pi / (settings().size() * hull_->spacing());
  const double cosine = std::cos(place.heading), sine = std::sin(place.heading);
  for (int my = 1 - half; my < half; ++my) {
    const std::size_t shared = static_cast<std::size_t>(std::abs(my));
    wake::turnRow({tables_->begin[shared], tables_->end[shared], half, hull_->values(),
                   hull_->alongX(), hull_->alongY(), static_cast<float>(unit * cosine),
                   static_cast<float>(unit * sine * my), static_cast<float>(-unit * sine),
                   static_cast<float>(unit * cosine * my), footprintReal_.row(rowOf(my)),
                   footprintImaginary_.row(rowOf(my))});
  }
}

void WakeWindow::settle(const HullPlace& place) {
  turnFootprint(place);
  const double size = settings().size();
  const AxisPhases x(settings().modes, fractionOf(place.position.x, size));
  const AxisPhases y(settings().modes, fractionOf(place.position.y, size));
  const int half = settings().modes / 2;
  forEachMode([&](int c, int my, std::size_t shared, std::size_t row) {
    // The gain over ω dt is W/L².
    const float turn = tables_->halfTurn.row(shared)[c];
    const float weight = turn > 0.0f ? static_cast<float>(place.immersion) *
                                           tables_->gain.row(shared)[c] / (2.0f * turn)
                                     : 0.0f;
    const std::complex<float> hollow =
        -weight * x.at(c - half) * y.at(my) *
        std::complex<float>(footprintReal_.row(row)[c], footprintImaginary_.row(row)[c]);
    real_.row(row)[c] = hollow.real();
    imaginary_.row(row)[c] = hollow.imag();
  });
}

void WakeWindow::step(double dt, const HullPlace& from, const HullPlace& to) {
  if (dt != tables_->dt) tables_ = std::make_shared<const WakeTables>(settings(), dt);
  HullPlace middle = from;
  middle.position = 0.5 * (from.position + to.position);
  middle.heading += 0.5 * std::remainder(to.heading - from.heading, 2.0 * pi);
  turnFootprint(middle);

  const int modes = settings().modes, half = modes / 2;
  const double size = settings().size();
  // The columns' places carry the immersion along.
  const glm::dvec2 drift = 0.5 * (to.position - from.position);  // U dt/2
  AxisPhases placeX(modes, fractionOf(middle.position.x, size));
  const AxisPhases placeY(modes, fractionOf(middle.position.y, size));
  const AxisPhases driftX(modes, drift.x / size), driftY(modes, drift.y / size);
  const float immersion = static_cast<float>(0.5 * (from.immersion + to.immersion));
  for (int c = 0; c < modes; ++c) placeX.real[c] *= immersion, placeX.imaginary[c] *= immersion;
  const double unit = 2.0 * pi / size;
  std::vector<float> turnX(static_cast<std::size_t>(modes) + 16);
  for (int c = 0; c < modes; ++c) turnX[c] = static_cast<float>(unit * (c - half) * drift.x);

  // Rows of k_y and −k_y read the same tables: one after the other.
  for (int r = 0; r < half; ++r) {
    for (const int my : {r, -r}) {
      const std::size_t row = rowOf(my);
      wake::stepRow({tables_->begin[r], tables_->end[r], tables_->cosine.row(r),
                     tables_->sine.row(r), tables_->halfTurn.row(r), tables_->gain.row(r),
                     footprintReal_.row(row), footprintImaginary_.row(row), placeX.columns(),
                     driftX.columns(), turnX.data(), placeY.at(my), driftY.at(my),
                     static_cast<float>(unit * my * drift.y), real_.row(row), imaginary_.row(row)});
      if (r == 0) break;
    }
  }
}

void WakeWindow::absorb(glm::dvec2 centre, double seconds) {
  const double a = -std::expm1(-settings().absorption * seconds);
  if (!(a > 0.0)) return;
  const std::vector<float> taps = borderTaps(a);
  const int modes = settings().modes, half = modes / 2;
  const double size = settings().size();
  // Times e^(+ik·x_seam), the seam lies at 0 and the taps are real.
  const AxisPhases x(modes, -fractionOf(centre.x / size + 0.5, 1.0));
  const AxisPhases y(modes, -fractionOf(centre.y / size + 0.5, 1.0));
  ModePlane real(modes, static_cast<std::size_t>(modes)), imaginary(real);
  std::vector<float> scratch(2 * (static_cast<std::size_t>(modes) + 32));
  const auto columnsOf = [&](int my) {
    const std::size_t shared = static_cast<std::size_t>(std::abs(my));
    return std::pair(tables_->begin[shared], tables_->end[shared]);
  };
  for (int my = 1 - half; my < half; ++my) {
    const auto [begin, end] = columnsOf(my);
    const std::size_t row = rowOf(my);
    wake::borderAlongRow({begin, end, modes, y.at(my), x.columns(), taps, real_.row(row),
                          imaginary_.row(row), real.row(row), imaginary.row(row), scratch.data()});
  }
  const float* realRows[2 * borderPower + 1];
  const float* imaginaryRows[2 * borderPower + 1];
  for (int my = 1 - half; my < half; ++my) {
    for (int q = -borderPower; q <= borderPower; ++q) {
      const bool inside = std::abs(my + q) < half;
      realRows[borderPower + q] = inside ? real.row(rowOf(my + q)) : nullptr;
      imaginaryRows[borderPower + q] = inside ? imaginary.row(rowOf(my + q)) : nullptr;
    }
    const auto [begin, end] = columnsOf(my);
    wake::borderAcrossRows({begin, end, y.at(my), x.columns(), taps, realRows, imaginaryRows,
                            real_.row(rowOf(my)), imaginary_.row(rowOf(my))});
  }
}

void WakeWindow::draw(WakeGrid& out) const {
  const wake::ModeState state{real_, imaginary_};
  wake::drawGrid(*tables_, state, state, fft_, out);
}

// η + H, and ∂η/∂t − U·∇H: Ẑ + Ĥ(1 + k·U/ω).
void WakeWindow::drawFilled(const HullPlace& place, glm::dvec2 velocity, WakeGrid& out) const {
  const int modes = settings().modes, half = modes / 2;
  const double size = settings().size(), unit = 2.0 * pi / (size * standardGravity);
  const AxisPhases x(modes, fractionOf(place.position.x, size));
  const AxisPhases y(modes, fractionOf(place.position.y, size));
  std::vector<float> paceX(static_cast<std::size_t>(modes));
  for (int c = 0; c < modes; ++c) paceX[c] = static_cast<float>(unit * (c - half) * velocity.x);
  ModePlane real = real_, imaginary = imaginary_;
  for (int my = 1 - half; my < half; ++my) {
    const std::size_t shared = static_cast<std::size_t>(std::abs(my)), row = rowOf(my);
    const float* const share = tables_->share.row(shared);
    const float* const slowness = tables_->gravityOverOmega.row(shared);
    const float *const hullReal = footprintReal_.row(row), *const hullOther =
                                                               footprintImaginary_.row(row);
    const std::complex<float> rowPlace = static_cast<float>(place.immersion) * y.at(my);
    const auto paceY = static_cast<float>(unit * my * velocity.y);
    float *const outReal = real.row(row), *const outImaginary = imaginary.row(row);
    for (int c = tables_->begin[shared]; c < tables_->end[shared]; ++c) {
      const float weight = share[c] * (1.0f + (paceX[c] + paceY) * slowness[c]);
      const float a = weight * (x.real[c] * rowPlace.real() - x.imaginary[c] * rowPlace.imag());
      const float b = weight * (x.real[c] * rowPlace.imag() + x.imaginary[c] * rowPlace.real());
      outReal[c] += a * hullReal[c] - b * hullOther[c];
      outImaginary[c] += a * hullOther[c] + b * hullReal[c];
    }
  }
  wake::drawGrid(*tables_, {real, imaginary}, {real_, imaginary_}, fft_, out);
}

std::vector<float> WakeWindow::envelope() const {
  return wake::envelope(*tables_, real_, imaginary_, fft_);
}

double WakeWindow::energy() const {
  double sum = 0.0;
  forEachMode([&](int c, int, std::size_t, std::size_t row) {
    const double re = real_.row(row)[c], im = imaginary_.row(row)[c];
    sum += re * re + im * im;
  });
  return sum;
}

double WakeWindow::meanWaveNumber() const {
  double sum = 0.0, weighted = 0.0;
  const int half = settings().modes / 2;
  forEachMode([&](int c, int my, std::size_t, std::size_t row) {
    const double re = real_.row(row)[c], im = imaginary_.row(row)[c];
    const double energy = re * re + im * im;
    sum += energy;
    weighted += energy * std::hypot(c - half, my);
  });
  return sum > 0.0 ? 2.0 * pi / settings().size() * weighted / sum : 0.0;
}

double WakeWindow::waveEnergy(const HullPlace& place) {
  turnFootprint(place);
  const double size = settings().size();
  const AxisPhases x(settings().modes, fractionOf(place.position.x, size));
  const AxisPhases y(settings().modes, fractionOf(place.position.y, size));
  const int half = settings().modes / 2;
  double sum = 0.0;
  forEachMode([&](int c, int my, std::size_t shared, std::size_t row) {
    const float turn = tables_->halfTurn.row(shared)[c];
    if (turn <= 0.0f) return;
    const float weight =
        static_cast<float>(place.immersion) * tables_->gain.row(shared)[c] / (2.0f * turn);
    const std::complex<float> z =
        std::complex<float>(real_.row(row)[c], imaginary_.row(row)[c]) +
        weight * x.at(c - half) * y.at(my) *
            std::complex<float>(footprintReal_.row(row)[c], footprintImaginary_.row(row)[c]);
    sum += std::norm(z);
  });
  return sum * size * size;
}

double WakeWindow::waveResistance(const HullPlace& place) {
  turnFootprint(place);
  const double size = settings().size(), unit = 2.0 * pi / size;
  const AxisPhases x(settings().modes, fractionOf(place.position.x, size));
  const AxisPhases y(settings().modes, fractionOf(place.position.y, size));
  const int half = settings().modes / 2;
  double sum = 0.0;
  forEachMode([&](int c, int my, std::size_t shared, std::size_t row) {
    const float turn = tables_->halfTurn.row(shared)[c];
    if (turn <= 0.0f) return;
    const double weight = place.immersion * tables_->gain.row(shared)[c] / (2.0 * turn);
    const std::complex<double> head =
        weight * std::complex<double>(x.at(c - half) * y.at(my)) *
        std::complex<double>(footprintReal_.row(row)[c], footprintImaginary_.row(row)[c]);
    const std::complex<double> height =
        0.5 * (std::complex<double>(mode(c - half, my)) +
               std::conj(std::complex<double>(mode(half - c, -my))));
    const double along =
        unit * ((c - half) * std::cos(place.heading) + my * std::sin(place.heading));
    sum += (std::conj(head) * std::complex<double>(0.0, along) * height).real();
  });
  return seaWaterDensity * standardGravity * sum * size * size;
}

std::complex<float> WakeWindow::mode(int mx, int my) const {
  const std::size_t c = static_cast<std::size_t>(mx + settings().modes / 2);
  return {real_.row(rowOf(my))[c], imaginary_.row(rowOf(my))[c]};
}

std::size_t WakeWindow::memoryBytes() const { return 4 * real_.values.size() * sizeof(float); }

template <class Archive>
void WakeWindow::archive(Archive& archive) {
  const std::size_t size = real_.values.size();
  archiveRow(archive, real_.values);
  archiveRow(archive, imaginary_.values);
  if (real_.values.size() != size || imaginary_.values.size() != size) {
    throw InputError("a checkpoint is damaged: a wake's window has another size");
  }
  footprintHeading_ = std::numeric_limits<double>::quiet_NaN();  // looked up again
}

template void WakeWindow::archive(StateWriter&);
template void WakeWindow::archive(StateReader&);

}  // namespace seaway
