#include "sim_bridge/scene/light_schema.h"

#include "sim_bridge/scene/schema_fields.h"

// Keys of a scene's light and lamps, and of vessels' lights.
namespace seaway::bridge {
namespace {

const Range elevations = Range::within(-90.0, 90.0);
const Range compass = Range::within(-360.0, 360.0);
const Range colours = Range::within(0.0, 1.0);

Mapping<render::ShadingTerms> shadingSchema() {
  using T = render::ShadingTerms;
  using enum render::Specular;
  using render::BackFaces;
  using render::Extinction;
  return Mapping<T>({
      choice("specular", &T::specular, {{"slopes", slopes}, {"phong", phong}, {"toman", toman}},
             "glitter: slopes: over the slopes that a pixel cannot show; phong: a lobe about the "
             "mirrored ray, exponent 256 (Johanson); toman: his term, shininess 0.6"),
      choice("extinction", &T::extinction,
             {{"exponential", Extinction::exponential}, {"linear", Extinction::linear}},
             "how water dims what is seen through it; linear: all gone where else 5 % is left "
             "(Toman)"),
      choice(
          "back_faces", &T::backFaces, {{"tilt", BackFaces::tilt}, {"keep", BackFaces::keep}},
          "normals that face away from the viewer: tilted until they do not (Kryachko), or kept"),
  });
}

}  // namespace

Mapping<LightSettings> lightSchema() {
  const Mapping<Sun> sun({
      number("elevation_deg", &Sun::elevation_deg, "°", elevations, "above the horizon"),
      number("azimuth_deg", &Sun::azimuth_deg, "°", compass, "compass direction it stands in"),
  });
  using M = SceneMoon;
  const Mapping<M> moon({
      number("elevation_deg", &M::elevation_deg, "°", elevations, "above the horizon"),
      number("azimuth_deg", &M::azimuth_deg, "°", compass, "compass direction it stands in"),
      number("phase", &M::phase, "1", Range::within(0.0, 1.0), "0 new, 0.5 full, 1 new again"),
  });
  const Mapping<Wind> wind({
      number("speed_m_s", &Wind::speed, "m/s", Range::within(0.0, 80.0),
             "at 12.5 m: roughness below the shortest waves of the field"),
      number("from_deg", &Wind::from_deg, "°", compass,
             "compass direction it blows from: pushes free hulls; without it none is pushed"),
  });
  using L = LightSettings;
  using render::ToneCurve;
  return Mapping<L>({
      mapping("sun", &L::sun, sun, "the sun"),
      mapping("moon", &L::moon, moon, "the moon, which shines while the sun is down"),
      mapping("wind", &L::wind, wind, "the wind, as pictures show it and free hulls feel it"),
      number("turbidity_per_m", &L::turbidity, "1/m", Range::within(0.0, 100.0),
             "what the water dims beyond clear water, any colour: coastal 0.1 to 1"),
      number("visibility_m", &L::visibility, "m", Range::within(10.0, 1e6),
             "distance at which haze leaves 2 % of a thing's contrast"),
      mapping("shading", &L::shading, shadingSchema(), "rival terms of the water's shading"),
      choice("tone_map", &L::toneCurve,
             {{"filmic", ToneCurve::filmic},
              {"reinhard", ToneCurve::reinhard},
              {"linear", ToneCurve::linear}},
             "how exposed radiance becomes a colour: filmic: a fit of the ACES curve; reinhard: "
             "white at 4 times the exposed light; linear: white from 1 on"),
      choice("dither", &L::dithers, {{"true", true}, {"false", false}},
             "colours are rounded by a fixed pattern of pixels, within one step of 255, so that "
             "slow gradients show no bands; radiance is not"),
  });
}

Mapping<SceneLamp> lampSchema(const Mapping<Place>& place) {
  using L = SceneLamp;
  return Mapping<L>({
      name("name", &L::name, "unique among lights"),
      mapping("place", &L::place, place, "where", Need::required),
      number("height_m", &L::height, "m", Range::within(-100.0, 1000.0),
             "above the still-water level"),
      vector("colour", &L::colour, "", colours, "linear: red, green, blue"),
      number("candela", &L::candela, "cd", Range::within(0.0, 1e7),
             "luminous intensity, all round"),
  });
}

Mapping<VesselLights> vesselLightsSchema() {
  using V = VesselLights;
  const Range places = Range::within(-1000.0, 1000.0);
  using enum LightsShown;
  return Mapping<V>({
      choice(
          "shown", &V::shown,
          {{"auto", automatic}, {"under_way", underWay}, {"at_anchor", atAnchor}, {"none", none}},
          "auto: under way with a speed, at anchor without, of a buoy its lantern; under_way: "
          "masthead, side and stern lights; at_anchor: a white light all round"),
      vector("masthead_m", &V::masthead, "m", places,
             "forward, to port, above the waterline at rest; also the light at anchor's and a "
             "lantern's; 0, 0, 0: by the hull's size"),
      vector("sidelight_m", &V::sidelight, "m", places, "the port one's; likewise"),
      vector("stern_m", &V::stern, "m", places, "likewise"),
  });
}

}  // namespace seaway::bridge
