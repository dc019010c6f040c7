#include "StippleArguments.h"

#include "Errors.h"
#include "InputArguments.h"
#include "RenderCommand.h"
#include "Text.h"

#include "vtkInkStippleControls.h"
#include "vtkInkStippleGenerator.h"
#include "vtkInkStippleMapper.h"
#include "vtkNew.h"

#include <algorithm>
#include <map>
#include <sstream>

namespace ink::cli
{

/// What an enhancement takes: its switch and its k's, with the mapper's ranges.
struct EnhancementKs
{
  struct K
  {
    const char* name;
    void (vtkInkStippleMapper::*set)(double);
    double (vtkInkStippleMapper::*least)();
    double (vtkInkStippleMapper::*greatest)();
  };
  const char* option;
  const char* names; ///< of the k's, as the user types them
  const char* effect;
  void (vtkInkStippleMapper::*enable)(bool);
  std::vector<K> ks;
};

namespace
{

using Mapper = vtkInkStippleMapper;
using Controls = vtkInkStippleControls;

constexpr const char* slidersGroup = "Stipples: a preset and what to change about it";
constexpr const char* placesGroup = "Stipples: where there are any";
constexpr const char* enhancementsGroup = "Stipples: enhancements, each with its k's, or on or off";
constexpr const char* marksGroup = "Stipples: marks";
constexpr const char* colorsGroup = "Stipples: colors";
constexpr double supersampling = PictureSize::supersampling;

const std::vector<EnhancementKs>& enhancementKs()
{
  static const std::vector<EnhancementKs> all{
    { "--boundary", "kgc,kgs,kge", "volumes: more where gradients are large: everywhere, there, sharpness",
      &Mapper::SetBoundary,
      { { "kgc", &Mapper::SetKgc, &Mapper::GetKgcMinValue, &Mapper::GetKgcMaxValue },
        { "kgs", &Mapper::SetKgs, &Mapper::GetKgsMinValue, &Mapper::GetKgsMaxValue },
        { "kge", &Mapper::SetKge, &Mapper::GetKgeMinValue, &Mapper::GetKgeMaxValue } } },
    { "--silhouette", "ksc,kss,kse",
      "volumes: more on silhouettes: everywhere, there, sharpness (sharper with a smaller one)",
      &Mapper::SetSilhouette,
      { { "ksc", &Mapper::SetKsc, &Mapper::GetKscMinValue, &Mapper::GetKscMaxValue },
        { "kss", &Mapper::SetKss, &Mapper::GetKssMinValue, &Mapper::GetKssMaxValue },
        { "kse", &Mapper::SetKse, &Mapper::GetKseMinValue, &Mapper::GetKseMaxValue } } },
    { "--resolution", "krc,knz", "as dense far away and at a slant as elsewhere: exponents of both",
      &Mapper::SetResolution,
      { { "krc", &Mapper::SetKrc, &Mapper::GetKrcMinValue, &Mapper::GetKrcMaxValue },
        { "knz", &Mapper::SetKnz, &Mapper::GetKnzMinValue, &Mapper::GetKnzMaxValue } } },
    { "--lighting", "kle", "fewer where light falls: exponent, more is lit with a smaller one",
      &Mapper::SetLighting,
      { { "kle", &Mapper::SetKle, &Mapper::GetKleMinValue, &Mapper::GetKleMaxValue } } },
    { "--distance-ks", "kde,size", "more and larger in front: exponent, how far the size follows",
      &Mapper::SetDistance,
      { { "kde", &Mapper::SetKde, &Mapper::GetKdeMinValue, &Mapper::GetKdeMaxValue },
        { "size", &Mapper::SetDistanceSize, &Mapper::GetDistanceSizeMinValue,
          &Mapper::GetDistanceSizeMaxValue } } },
    { "--interior-ks", "kie,size",
      "volumes: fewer and smaller where gradients are small: exponent, how far the size follows",
      &Mapper::SetInterior,
      { { "kie", &Mapper::SetKie, &Mapper::GetKieMinValue, &Mapper::GetKieMaxValue },
        { "size", &Mapper::SetInteriorSize, &Mapper::GetInteriorSizeMinValue,
          &Mapper::GetInteriorSizeMaxValue } } },
  };
  return all;
}

/// "1, 2" and so on; a part that is no number is named.
std::vector<std::string> split(const std::string& list)
{
  std::vector<std::string> parts;
  std::istringstream stream(list);
  for (std::string part; std::getline(stream, part, ',');)
  {
    parts.push_back(part);
  }
  if (list.empty() || list.back() == ',')
  {
    parts.emplace_back();
  }
  return parts;
}

/// Sets an enhancement's k's, which turns it on, or turns it on or off.
void apply(const EnhancementKs& enhancement, const std::string& given, Mapper* mapper)
{
  const std::string problem = std::string(enhancement.option) + " '" + given + "': ";
  const bool off = given == "off";
  (mapper->*enhancement.enable)(!off);
  if (off || given == "on")
  {
    return;
  }
  const std::vector<std::string> parts = split(given);
  const std::size_t count = enhancement.ks.size();
  if (parts.size() != count)
  {
    throw UsageError(problem + "expected " + enhancement.names + " (" + std::to_string(count) +
      (count == 1 ? " number" : " numbers") + "), on or off; found " + std::to_string(parts.size()));
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const EnhancementKs::K& k = enhancement.ks[i];
    std::string part = parts[i];
    const double least = (mapper->*k.least)();
    const double greatest = (mapper->*k.greatest)();
    if (const std::string wrong = within(least, greatest)(part); !wrong.empty())
    {
      throw UsageError(problem + k.name + ": expected a number from " + text(least) + " to " +
        text(greatest) + ", found '" + part + "'");
    }
    (mapper->*k.set)(std::stod(part));
  }
}

const std::map<std::string, std::vector<Color>>& colorMaps()
{
  static const std::map<std::string, std::vector<Color>> maps{
    { "cool-warm", { { 0.23, 0.30, 0.75 }, { 0.50, 0.45, 0.45 }, { 0.71, 0.02, 0.15 } } },
    { "rainbow",
      { { 0.0, 0.0, 0.8 }, { 0.0, 0.6, 0.8 }, { 0.0, 0.6, 0.0 }, { 0.8, 0.6, 0.0 }, { 0.8, 0.0, 0.0 } } },
    { "viridis",
      { { 0.267, 0.005, 0.329 }, { 0.230, 0.322, 0.546 }, { 0.128, 0.567, 0.551 }, { 0.369, 0.789, 0.383 },
        { 0.993, 0.906, 0.144 } } },
  };
  return maps;
}

std::vector<Color> parseColorMap(const std::string& text)
{
  if (const auto found = colorMaps().find(text); found != colorMaps().end())
  {
    return found->second;
  }
  const std::vector<std::string> names = split(text);
  if (names.size() < 2)
  {
    std::string known;
    for (const auto& [name, colors] : colorMaps())
    {
      known += name + ", ";
    }
    throw UsageError("--color-map '" + text + "': expected " + known + "or two or more colors with commas");
  }
  std::vector<Color> colors;
  for (const std::string& name : names)
  {
    colors.push_back(parseColor("--color-map", name));
  }
  return colors;
}

double lightness(const Color& c)
{
  return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
}

} // namespace

CLI::Option* StippleArguments::keep(CLI::Option* option, const char* group)
{
  this->all.push_back(option->group(group));
  return option;
}

void StippleArguments::add(CLI::App* command)
{
  this->addSliders(command);
  this->addPlaces(command);
  this->addEnhancements(command);
  this->addMarks(command);
  this->addColors(command);
}

void StippleArguments::addSliders(CLI::App* command)
{
  std::vector<std::string> names;
  for (int i = 0; i < Controls::GetNumberOfPresets(); ++i)
  {
    names.emplace_back(Controls::GetPresetName(i));
  }
  this
    ->keep(command->add_option("--preset", this->preset,
             "anatomy, bone, soft-tissue, engineering or plate-white-on-black (anatomy)"),
      slidersGroup)
    ->type_name("NAME")
    ->check(CLI::IsMember(names, CLI::ignore_case));
  const auto slider = [&](const char* name, void (Controls::*set)(double), const char* effect)
  {
    auto& number = this->sliders.emplace_back(Number<Controls>{ {}, set, 1.0 });
    this->keep(command->add_option(name, number.value, effect), slidersGroup)->check(within(0.0, 1.0));
  };
  slider("--gradient", &Controls::SetGradient, "more ink on boundaries");
  slider("--sharpness", &Controls::SetSharpness, "less ink, in a smaller place");
  slider("--orientation", &Controls::SetOrientation, "darker rims, lighter middles; 0: hardly any light");
  slider("--distance", &Controls::SetDistance, "nearer parts stand out");
  slider("--interior", &Controls::SetInterior, "weak boundaries are see-through");
  slider("--color", &Controls::SetColor, "warm and cool colors in place of ink");
  this
    ->keep(command->add_option("--light", this->light,
             "where light comes from: degrees to the viewer's right, degrees above (-30,30)"),
      slidersGroup)
    ->delimiter(',')
    ->expected(2)
    ->type_name("AZ,EL")
    ->check(within(-180.0, 180.0));
}

void StippleArguments::addPlaces(CLI::App* command)
{
  vtkNew<vtkInkStippleGenerator> generator;
  const auto described = [](const char* effect, double standard)
  { return std::string(effect) + " (" + text(standard) + ")"; };
  this
    ->keep(command->add_option("--max-stipples", this->listLength,
             described("stipples in a voxel or, on average, in a polygon; more for close-ups",
               generator->GetMaximumStipples())),
      placesGroup)
    ->type_name("N")
    ->check(within(generator->GetMaximumStipplesMinValue(), generator->GetMaximumStipplesMaxValue()));
  auto* share = this->keep(command->add_option("--percentile", this->percentile,
                             described("volumes: how many percent of the voxels have too small a gradient",
                               generator->GetGradientPercentile())),
    placesGroup);
  share->type_name("P")->check(within(0.0, 100.0));
  this
    ->keep(command->add_option("--threshold", this->threshold,
             "volumes: the smallest gradient with stipples, in value per unit of length, in place of "
             "--percentile"),
      placesGroup)
    ->type_name("G")
    ->check(within(0.0, 1e300))
    ->excludes(share);
  this->keep(command->add_option("--window", this->window, "volumes: the values with stipples"), placesGroup)
    ->delimiter(',')
    ->expected(2)
    ->type_name("LO,HI")
    ->check(within(-1e300, 1e300));
  this
    ->keep(command->add_option("--seed", this->seed, "another seed makes other stipples, just as good (0)"),
      placesGroup)
    ->type_name("N");
}

void StippleArguments::addEnhancements(CLI::App* command)
{
  for (const EnhancementKs& ks : enhancementKs())
  {
    auto& enhancement = this->enhancements.emplace_back(Enhancement{ &ks, {} });
    this->keep(command->add_option(ks.option, enhancement.text, ks.effect), enhancementsGroup)
      ->type_name(ks.names);
  }
  const auto number =
    [&](const char* name, void (Mapper::*set)(double), double least, double greatest, const char* effect)
  {
    auto& added = this->numbers.emplace_back(Number<Mapper>{ {}, set, 1.0 });
    this->keep(command->add_option(name, added.value, effect), enhancementsGroup)
      ->check(within(least, greatest));
  };
  number("--facing-angle", &Mapper::SetFacingAngle, 0.0, 180.0,
    "volumes with light: voxels are drawn up to this angle between normal and eye, degrees (90)");
  number("--value-effect", &Mapper::SetValueEffect, 0.0, 1.0,
    "volumes: how much values count beside gradients; 1: as published (the preset's)");
}

void StippleArguments::addMarks(CLI::App* command)
{
  vtkNew<vtkInkStippleMapper> mapper;
  const auto number = [&](const char* name, void (Mapper::*set)(double), double least, double greatest,
                        double factor, const char* effect)
  {
    auto& added = this->numbers.emplace_back(Number<Mapper>{ {}, set, factor });
    this->keep(command->add_option(name, added.value, effect), marksGroup)
      ->check(within(least, greatest / factor));
  };
  number("--stipple-size", &Mapper::SetStippleSize, mapper->GetStippleSizeMinValue(),
    mapper->GetStippleSizeMaxValue(), supersampling, "diameter in pixels (the preset's)");
  number("--pixels-per-stipple", &Mapper::SetPixelsPerStipple, mapper->GetPixelsPerStippleMinValue(),
    mapper->GetPixelsPerStippleMaxValue(), supersampling * supersampling,
    "pixels of an element that make room for a stipple; darker with fewer (the preset's; less with --iso)");
  this->room = this->all.back();
  number("--fade", &Mapper::SetFade, 0.0, 1.0, 1.0,
    "over how much of a stipple stipples appear; 0: all are whole, 1: pale ones keep the gray exact (1)");
  number("--minimum-coverage", &Mapper::SetMinimumCoverage, mapper->GetMinimumCoverageMinValue(),
    mapper->GetMinimumCoverageMaxValue(), 1.0, "elements with room for fewer stipples count as small (9)");
  this
    ->keep(command->add_option("--parts", this->parts,
             "parts of stipples are smaller ones (size), paler ones (intensity) or, in small elements, whole "
             "ones by chance\n(probability) (the preset's)"),
      marksGroup)
    ->type_name("HOW")
    ->check(CLI::IsMember({ "size", "intensity", "probability" }));
  this->keep(command->add_flag("--no-growing", this->noGrowing,
               "stipples stay small where an element has room for more than it has"),
    marksGroup);
  number("--occluder-offset", &Mapper::SetOccluderOffset, 0.0, mapper->GetOccluderOffsetMaxValue(), 1.0,
    "how far behind a surface stipples are seen, in voxels or polygons (1.5 or 0.1)");
}

void StippleArguments::addColors(CLI::App* command)
{
  this
    ->keep(command->add_option("--color-map", this->colorMap,
             "colors for scalars: cool-warm, rainbow, viridis, or colors with commas (none: ink)"),
      colorsGroup)
    ->type_name("MAP");
  this
    ->keep(command->add_option("--color-by", this->colorBy, "which array to color by (the active one)"),
      colorsGroup)
    ->type_name("ARRAY")
    ->needs("--color-map");
  this
    ->keep(command->add_option("--color-range", this->colorRange,
             "values of the first and the last color (those of the stipples)"),
      colorsGroup)
    ->delimiter(',')
    ->expected(2)
    ->type_name("LO,HI")
    ->needs("--color-map")
    ->check(within(-1e300, 1e300));
  this->keep(command->add_option("--warm-color", this->warmColor, "of --color (red)"), colorsGroup)
    ->type_name("COLOR");
  this->keep(command->add_option("--cool-color", this->coolColor, "of --color (blue)"), colorsGroup)
    ->type_name("COLOR");
  const auto weight = [&](const char* name, void (Mapper::*set)(double), const char* effect)
  {
    auto& added = this->numbers.emplace_back(Number<Mapper>{ {}, set, 1.0 });
    this->keep(command->add_option(name, added.value, effect), colorsGroup)->check(within(0.0, 1.0));
  };
  weight("--tone-weight", &Mapper::SetToneWeight, "how much light decides between warm and cool (1)");
  weight("--distance-weight", &Mapper::SetDistanceWeight, "how much distance does (0)");
}

StippleStyle StippleArguments::style(const std::optional<Color>& ink, const std::optional<Color>& paper) const
{
  StippleStyle style;
  style.generator = vtkSmartPointer<vtkInkStippleGenerator>::New();
  style.mapper = vtkSmartPointer<vtkInkStippleMapper>::New();
  style.lightAzimuth = this->light[0];
  style.lightElevation = this->light[1];
  this->setUpGenerator(style);

  vtkNew<vtkInkStippleControls> controls;
  controls->SetPreset(this->preset.c_str());
  for (const auto& slider : this->sliders)
  {
    if (slider.value)
    {
      (controls.Get()->*slider.set)(*slider.value);
    }
  }
  Mapper* mapper = style.mapper;
  controls->Apply(mapper);
  controls->GetPaperColor(style.paper.data());
  mapper->SetStippleSize(supersampling * mapper->GetStippleSize());
  mapper->SetPixelsPerStipple(supersampling * supersampling * mapper->GetPixelsPerStipple());
  for (const Enhancement& enhancement : this->enhancements)
  {
    if (enhancement.text)
    {
      apply(*enhancement.ks, *enhancement.text, mapper);
    }
  }
  for (const auto& number : this->numbers)
  {
    if (number.value)
    {
      (mapper->*number.set)(*number.value * number.factor);
    }
  }
  if (!this->parts.empty())
  {
    mapper->SetSmallElements(this->parts == "probability" ? Mapper::PROBABILITY : Mapper::INTENSITY);
    mapper->SetAppearBySize(this->parts == "size");
  }
  mapper->SetGrowing(!this->noGrowing);
  style.roomGiven = this->room->count() > 0;
  if (ink)
  {
    mapper->SetInkColor(ink->data());
  }
  style.paper = paper.value_or(style.paper);
  if (ink || paper)
  {
    Color used;
    mapper->GetInkColor(used.data());
    mapper->SetLightInk(lightness(used) > lightness(style.paper));
  }
  this->setUpColors(style);
  return style;
}

void StippleArguments::setUpGenerator(StippleStyle& style) const
{
  vtkInkStippleGenerator* generator = style.generator;
  generator->SetSeed(this->seed);
  if (this->listLength)
  {
    generator->SetMaximumStipples(*this->listLength);
    style.listLengthGiven = true;
  }
  if (this->percentile)
  {
    generator->SetGradientPercentile(*this->percentile);
    style.volumeOption = "--percentile";
  }
  if (this->threshold)
  {
    generator->SetThresholdModeToMagnitude();
    generator->SetGradientThreshold(*this->threshold);
    style.volumeOption = "--threshold";
  }
  if (!this->window.empty())
  {
    if (this->window[0] > this->window[1])
    {
      throw UsageError("--window " + text(this->window[0]) + "," + text(this->window[1]) +
        ": expected the lower value first");
    }
    generator->UseScalarWindowOn();
    generator->SetScalarWindow(this->window[0], this->window[1]);
    style.volumeOption = "--window";
  }
}

void StippleArguments::setUpColors(StippleStyle& style) const
{
  if (!this->colorMap.empty())
  {
    ScalarColors colors{ parseColorMap(this->colorMap), this->colorBy, {} };
    if (!this->colorRange.empty())
    {
      if (!(this->colorRange[0] < this->colorRange[1]))
      {
        throw UsageError("--color-range " + text(this->colorRange[0]) + "," + text(this->colorRange[1]) +
          ": expected the lower value first");
      }
      colors.range = { this->colorRange[0], this->colorRange[1] };
    }
    style.scalarColors = std::move(colors);
  }
  if (!this->warmColor.empty())
  {
    style.mapper->SetWarmColor(parseColor("--warm-color", this->warmColor).data());
  }
  if (!this->coolColor.empty())
  {
    style.mapper->SetCoolColor(parseColor("--cool-color", this->coolColor).data());
  }
}

} // namespace ink::cli
