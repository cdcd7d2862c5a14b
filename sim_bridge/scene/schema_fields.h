#pragma once

#include <memory>
#include <type_traits>

#include "sim_bridge/scene/schema.h"

/// The kinds of key that schema tables are made of. Defaults on the schema page are the members'
/// own initial values.
namespace seaway::bridge {

namespace detail {
inline std::string componentText(int value) { return std::to_string(value); }
inline std::string componentText(float value) { return numberText(value); }
inline std::string componentText(double value) { return numberText(value); }
inline std::string defaultOf(double value) { return numberText(value); }
inline std::string defaultOf(const std::optional<double>&) { return ""; }
}  // namespace detail

/// A number; `M` is double or std::optional<double>.
template <class T, class M>
Field<T> number(std::string key, M T::*member, std::string unit, Range range, std::string summary,
                Need need = Need::optional) {
  KeyDescription description{std::move(key), "number",           unit, range.text(), "",
                             need,           std::move(summary), {}};
  description.range = range;
  if (need == Need::optional) description.defaultText = detail::defaultOf(T{}.*member);
  return {std::move(description), [=](T& target, const YamlValue& value) {
            target.*member = readNumber(value, range, unit);
          }};
}

template <class T, class I>
requires std::is_integral_v<I> Field<T> integer(std::string key, I T::*member, std::int64_t least,
                                                std::int64_t most, std::string summary,
                                                Need need = Need::optional) {
  KeyDescription description{std::move(key), "integer", "", "", "", need, std::move(summary), {}};
  description.allowed = "[" + std::to_string(least) + ", " + std::to_string(most) + "]";
  description.range = Range::within(static_cast<double>(least), static_cast<double>(most));
  if (need == Need::optional) description.defaultText = std::to_string(T{}.*member);
  return {std::move(description), [=](T& target, const YamlValue& value) {
            target.*member = static_cast<I>(readInteger(value, least, most));
          }};
}

template <class T>
Field<T> text(std::string key, std::string T::*member, std::string summary,
              Need need = Need::optional) {
  KeyDescription description{std::move(key), "text", "", "", "", need, std::move(summary), {}};
  if (need == Need::optional) description.defaultText = T{}.*member;
  return {std::move(description),
          [=](T& target, const YamlValue& value) { target.*member = readText(value); }};
}

/// A name: of something in the scene, and of files about it.
template <class T>
Field<T> name(std::string key, std::string T::*member, std::string summary) {
  KeyDescription description{std::move(key),          "name", "",
                             "letters, digits, _, -", "",     Need::required,
                             std::move(summary),      {}};
  return {std::move(description),
          [=](T& target, const YamlValue& value) { target.*member = readName(value); }};
}

/// One of a few words.
template <class T, class M>
Field<T> choice(std::string key, M T::*member, std::vector<std::pair<std::string, M>> choices,
                std::string summary, Need need = Need::optional) {
  std::vector<std::string> words;
  KeyDescription description{std::move(key), "word", "", "", "", need, std::move(summary), {}};
  for (const auto& [word, meaning] : choices) {
    words.push_back(word);
    description.allowed += (description.allowed.empty() ? "" : ", ") + word;
    if (need == Need::optional && T{}.*member == meaning) description.defaultText = word;
  }
  description.words = words;
  return {std::move(description),
          [member, words, choices = std::move(choices)](T& target, const YamlValue& value) {
            for (const auto& [word, meaning] : choices) {
              if (value.kind == YamlValue::Kind::scalar && value.scalar == word) {
                target.*member = meaning;
                return;
              }
            }
            failChoice(value, words);
          }};
}

/// A list of as many numbers as the vector `V` (glm::dvec3, glm::ivec2 …) has components.
template <class T, class V>
Field<T> vector(std::string key, V T::*member, std::string unit, Range range, std::string summary,
                Need need = Need::optional) {
  using Component = typename V::value_type;
  constexpr int size = V::length();
  const std::string wanted = "a list of " + std::to_string(size) +
                             (std::is_integral_v<Component> ? " whole numbers" : " numbers");
  KeyDescription description{std::move(key),     wanted, unit, range.text(), "", need,
                             std::move(summary), {}};
  description.range = range;
  description.components = size;
  if (need == Need::optional) {
    const V initial = T{}.*member;
    for (int i = 0; i < size; ++i) {
      description.defaultText += (i ? ", " : "[") + detail::componentText(initial[i]);
    }
    description.defaultText += "]";
  }
  return {std::move(description), [=](T& target, const YamlValue& value) {
            requireKind(value, YamlValue::Kind::list, wanted.c_str());
            if (value.values.size() != size) value.fail("must be " + wanted);
            for (int i = 0; i < size; ++i) {
              if constexpr (std::is_integral_v<Component>) {
                (target.*member)[i] = static_cast<Component>(
                    readInteger(value.values[i], static_cast<std::int64_t>(range.least),
                                static_cast<std::int64_t>(range.most)));
              } else {
                (target.*member)[i] =
                    static_cast<Component>(readNumber(value.values[i], range, unit));
              }
            }
          }};
}

namespace detail {
template <class M>
KeyDescription describeMapping(std::string key, const char* type, const Mapping<M>& inner,
                               std::string summary, Need need) {
  return {std::move(key),
          inner.exactlyOne() ? "mapping with one of these keys" : type,
          "",
          "",
          "",
          need,
          std::move(summary),
          inner.describe()};
}
}  // namespace detail

/// A nested mapping; `M` is the inner struct or std::optional of it.
template <class T, class M, class I>
Field<T> mapping(std::string key, M T::*member, const Mapping<I>& inner, std::string summary,
                 Need need = Need::optional) {
  return {detail::describeMapping(std::move(key), "mapping", inner, std::move(summary), need),
          [=](T& target, const YamlValue& value) { target.*member = inner.read(value); }};
}

template <class T, class M>
Field<T> list(std::string key, std::vector<M> T::*member, const Mapping<M>& inner,
              std::string summary, Need need = Need::optional) {
  return {
      detail::describeMapping(std::move(key), "list of mappings", inner, std::move(summary), need),
      [=](T& target, const YamlValue& value) {
        requireKind(value, YamlValue::Kind::list, "a list");
        for (const YamlValue& item : value.values) {
          (target.*member).push_back(inner.read(item));
        }
      }};
}

/// One alternative of a variant, chosen by its key; the inner mapping fills an `M`.
template <class Variant, class M>
Field<Variant> alternative(std::string key, const Mapping<M>& inner, std::string summary) {
  return {
      detail::describeMapping(std::move(key), "mapping", inner, std::move(summary), Need::optional),
      [=](Variant& target, const YamlValue& value) { target = inner.read(value); }};
}

}  // namespace seaway::bridge
