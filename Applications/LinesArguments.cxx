#include "LinesArguments.h"

#include "InputArguments.h"
#include "RenderCommand.h"

#include "vtkInkSplattingLinesMapper.h"
#include "vtkNew.h"

#include <algorithm>
#include <array>
#include <limits>
#include <sstream>

namespace ink::cli
{
namespace
{

using Mapper = vtkInkSplattingLinesMapper;

constexpr const char* linesGroup = "Lines";
constexpr const char* looksGroup = "Lines: what becomes of them";
constexpr const char* hiddenGroup = "Lines: hidden ones, with --layers";
constexpr const char* speedGroup = "Lines: speed against accuracy";

/// What the mapper takes: it clamps what is beyond.
/// \param set, get called with the mapper, and a value to set
template <class Set, class Get>
std::array<double, 2> rangeOf(const Set& set, const Get& get)
{
  vtkNew<Mapper> mapper;
  std::array<double, 2> range{};
  set(mapper.Get(), std::numeric_limits<double>::lowest());
  range[0] = get(mapper.Get());
  set(mapper.Get(), std::numeric_limits<double>::max());
  range[1] = get(mapper.Get());
  return range;
}

std::string withDefault(const char* effect, double preset)
{
  std::ostringstream description;
  description << effect << " (" << preset << ")";
  return description.str();
}

} // namespace

CLI::Option* LinesArguments::keep(CLI::Option* option, const char* group)
{
  this->all.push_back(option->group(group));
  return option;
}

void LinesArguments::addNumber(CLI::App* command, const char* group, const char* name,
  double (Mapper::*get)(), void (Mapper::*set)(double), const char* effect, double factor)
{
  // Ranges and defaults are the mapper's own.
  vtkNew<Mapper> mapper;
  const auto [least, greatest] = rangeOf(
    [set](Mapper* of, double value) { (of->*set)(value); }, [get](Mapper* of) { return (of->*get)(); });
  Number& number = this->numbers.emplace_back(Number{ {}, set, factor });
  this->keep(command->add_option(name, number.value, withDefault(effect, (mapper->*get)() / factor)), group)
    ->check(within(least / factor, greatest / factor));
}

void LinesArguments::add(CLI::App* command)
{
  const auto number = [&](const char* group)
  {
    return [this, command, group](const char* name, double (Mapper::*get)(), void (Mapper::*set)(double),
             const char* effect, double factor = 1.0)
    { this->addNumber(command, group, name, get, set, effect, factor); };
  };
  const auto line = number(linesGroup);
  line("--tau", &Mapper::GetTau, &Mapper::SetTau, "threshold: more lines with a larger one");
  line("--phi", &Mapper::GetPhi, &Mapper::SetPhi, "strength: darker lines with a larger one");
  line("--lambda", &Mapper::GetLambda, &Mapper::SetLambda, "detail: fewer, broader lines with a larger one");
  line("--sigma", &Mapper::GetSigma, &Mapper::SetSigma, "width of the narrower Gaussian as part of a splat");
  line("--minimum-radius", &Mapper::GetMinimumRadius, &Mapper::SetMinimumRadius,
    "least radius of splats, in thousandths of the picture's height: thinner lines with a smaller one");
  this->keep(command->add_flag("--as-published", this->asPublished,
               "splat exactly as in the paper: without what makes contours solid and lines smooth"),
    linesGroup);

  const auto look = number(looksGroup);
  look("--hardness", &Mapper::GetHardness, &Mapper::SetHardness, "from soft lines to hard ones");
  look("--line-width", &Mapper::GetLineWidth, &Mapper::SetLineWidth,
    "what is added to the lines' width, in thousandths of the picture's height");
  look("--speckles", &Mapper::GetSpeckleLength, &Mapper::SetSpeckleLength,
    "leave out spots of ink shorter than so many pixels", PictureSize::supersampling);
  this->keep(command->add_flag("--thin", this->thin, "thin all lines to half a pixel, before --line-width"),
    looksGroup);
  this
    ->keep(command->add_option("--tone-color", this->toneColor,
             "color of lines where the surface faces the viewer; towards contours they get the ink's"),
      looksGroup)
    ->type_name("COLOR");

  this->addHidden(command);

  vtkNew<Mapper> mapper;
  this
    ->keep(command->add_option("--coarsest-texel", this->coarsestTexel,
             withDefault(
               "sum up large splats for squares of so many pixels, 1: exact", mapper->GetCoarsestTexel())),
      speedGroup)
    ->type_name("N")
    ->check(CLI::IsMember({ 1, 2, 4 }));
  this->keep(command->add_flag("--half-floats", this->halfFloats, "sum up in 16 bits"), speedGroup);
  number(speedGroup)("--point-fraction", &Mapper::GetPointFraction, &Mapper::SetPointFraction,
    "part of the points to draw, with larger splats");
}

void LinesArguments::addHidden(CLI::App* command)
{
  vtkNew<Mapper> mapper;
  CLI::Option* layersOption =
    this
      ->keep(command->add_option("--layers", this->layers,
               "draw this many surfaces that lie behind each other, the visible one included (1)"),
        hiddenGroup)
      ->type_name("N")
      ->check(CLI::Range(mapper->GetNumberOfLayersMinValue(), mapper->GetNumberOfLayersMaxValue()));
  const auto hidden = [&](const char* name, std::optional<double>& value, double (Mapper::*get)(int),
                        void (Mapper::*set)(int, double), const char* effect)
  {
    const auto [least, greatest] = rangeOf(
      [set](Mapper* of, double to) { (of->*set)(1, to); }, [get](Mapper* of) { return (of->*get)(1); });
    this->keep(command->add_option(name, value, withDefault(effect, (mapper.Get()->*get)(1))), hiddenGroup)
      ->check(within(least, greatest))
      ->needs(layersOption);
  };
  hidden("--hidden-strength", this->hiddenStrength, &Mapper::GetLayerStrength, &Mapper::SetLayerStrength,
    "how much of its ink the second layer gets; each further one two thirds of that before");
  hidden("--hidden-width", this->hiddenWidth, &Mapper::GetLayerLineWidth, &Mapper::SetLayerLineWidth,
    "--line-width of hidden layers");
  hidden("--hidden-dashes", this->hiddenDashes, &Mapper::GetLayerDashLength, &Mapper::SetLayerDashLength,
    "length of dashes and gaps, in thousandths of the picture's height; 0: solid");
  this
    ->keep(command->add_option("--hidden-color", this->hiddenColors,
             "color of the second layer's lines, and of further ones with commas; those left take the last "
             "(the ink's)"),
      hiddenGroup)
    ->delimiter(',')
    ->type_name("COLOR,...")
    ->needs(layersOption);
  this
    ->keep(command->add_flag("--peel-back-faces", this->backFaces, "inner sides of surfaces are layers, too"),
      hiddenGroup)
    ->needs(layersOption);
}

vtkSmartPointer<vtkInkSplattingLinesMapper> LinesArguments::mapper(const std::optional<Color>& ink) const
{
  auto mapper = vtkSmartPointer<Mapper>::New();
  for (const Number& number : this->numbers)
  {
    if (number.value)
    {
      (mapper->*number.set)(*number.value * number.factor);
    }
  }
  mapper->SetAsPublished(this->asPublished);
  mapper->SetThinning(this->thin);
  mapper->SetHalfFloats(this->halfFloats);
  mapper->SetCoarsestTexel(this->coarsestTexel.value_or(mapper->GetCoarsestTexel()));
  if (ink)
  {
    mapper->SetInkColor(ink->data());
  }
  if (!this->toneColor.empty())
  {
    mapper->SetToneColor(parseColor("--tone-color", this->toneColor).data());
    mapper->SetInkColorMode(Mapper::TONE);
  }
  mapper->SetHiddenLayers(this->layers > 1);
  mapper->SetNumberOfLayers(this->layers);
  mapper->SetPeelBackFaces(this->backFaces);
  const double ofSecond = mapper->GetLayerStrength(1);
  const double share = this->hiddenStrength.value_or(ofSecond) / ofSecond;
  for (int layer = 1; layer < this->layers; ++layer)
  {
    mapper->SetLayerStrength(layer, share * mapper->GetLayerStrength(layer));
    mapper->SetLayerLineWidth(layer, this->hiddenWidth.value_or(mapper->GetLayerLineWidth(layer)));
    mapper->SetLayerDashLength(layer, this->hiddenDashes.value_or(0.0));
    if (!this->hiddenColors.empty())
    {
      const auto last = static_cast<int>(this->hiddenColors.size());
      const std::string& color = this->hiddenColors[static_cast<std::size_t>(std::min(layer, last) - 1)];
      mapper->SetLayerColor(layer, parseColor("--hidden-color", color).data());
    }
  }
  return mapper;
}

} // namespace ink::cli
