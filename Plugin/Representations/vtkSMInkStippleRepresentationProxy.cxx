// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMInkStippleRepresentationProxy.h"

#include "InkParameter.h"
#include "vtkInkStippleStyle.h"
#include "vtkSMInkDoubleVectorProperty.h"
#include "vtkSMInkIntVectorProperty.h"
#include "vtkSMInkIsoValueInitializationHelper.h"
#include "vtkSMInkRestoring.h"

#include "vtkDataSetAttributes.h"
#include "vtkObjectFactory.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMSourceProxy.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkSMInkStippleRepresentationProxy);

namespace
{

constexpr const char* Prefix = "Stipple";
constexpr const char* PresetProperty = "StipplePreset";
constexpr const char* Sliders[] = { "StippleGradient", "StippleSharpness", "StippleOrientation",
  "StippleDistance", "StippleInterior", "StippleColor" };

/// What starts with a value that suits the input when it is switched on.
struct Start
{
  const char* Switch;
  int On;
  const char* Property;
  void (*Set)(vtkSMProxy*, const char* property);
};

constexpr const char* ArrayProperty = "StippleBy";

constexpr Start Starts[] = {
  { "UseScalarWindow", 1, "ScalarWindow",
    [](vtkSMProxy* proxy, const char* property) { proxy->GetProperty(property)->ResetToDomainDefaults(); } },
  { "StippleSource", vtkInkStippleStyle::ISO_SURFACE, "StippleIsoValue",
    [](vtkSMProxy* proxy, const char* property)
    {
      if (const auto value = vtkSMInkIsoValueInitializationHelper::Suggest(proxy, ArrayProperty))
      {
        vtkSMPropertyHelper(proxy, property).Set(*value);
      }
    } },
};

bool IsOn(vtkSMProxy* proxy, const Start& start)
{
  return vtkSMPropertyHelper(proxy, start.Switch).GetAsInt() == start.On;
}

/// Ranges are those of an array with a name: that of the active scalars, if none is chosen.
void ChooseArray(vtkSMProxy* proxy)
{
  const vtkSMPropertyHelper inputs(proxy, "Input");
  auto input = vtkSMSourceProxy::SafeDownCast(inputs.GetAsProxy());
  if (!input || !proxy->GetProperty(ArrayProperty)->IsValueDefault())
  {
    return;
  }
  input->UpdatePipeline();
  const vtkPVArrayInformation* scalars = input->GetDataInformation(inputs.GetOutputPort())
                                           ->GetPointDataInformation()
                                           ->GetAttributeInformation(vtkDataSetAttributes::SCALARS);
  if (scalars && scalars->GetName())
  {
    constexpr unsigned int name = 4;
    vtkSMPropertyHelper(proxy, ArrayProperty).Set(name, scalars->GetName());
  }
}

/// The parameter that a property sets, whose name it has, or has after a prefix; null for others.
const InkParameter* ParameterOf(vtkInkStyle* style, const std::string& property)
{
  const InkParameterTable& table = style->GetParameterTable();
  const InkParameter* parameter = table.Find(property);
  return parameter || property.rfind(Prefix, 0) != 0 ? parameter
                                                     : table.Find(property.substr(std::strlen(Prefix)));
}

/// ParaView's properties of integers take no array of doubles.
void Set(vtkSMProxy* proxy, const std::string& property, const std::vector<double>& numbers)
{
  vtkSMPropertyHelper helper(proxy, property.c_str());
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    helper.Set(static_cast<unsigned int>(i), numbers[i]);
  }
}

std::vector<double> Get(vtkSMProxy* proxy, const std::string& property)
{
  const vtkSMPropertyHelper helper(proxy, property.c_str());
  std::vector<double> numbers;
  for (unsigned int i = 0; i < helper.GetNumberOfElements(); ++i)
  {
    numbers.push_back(helper.GetAsDouble(i));
  }
  return numbers;
}

std::vector<double> ValueOf(vtkInkStyle* style, const std::string& property)
{
  return ParameterOf(style, property)->Get(style).Numbers;
}

bool IsUnset(vtkSMProxy* proxy, const Start& start)
{
  return vtkSMInkDoubleVectorProperty::SafeDownCast(proxy->GetProperty(start.Property))->IsUnset();
}

} // namespace

vtkSMInkStippleRepresentationProxy::vtkSMInkStippleRepresentationProxy() = default;

vtkSMInkStippleRepresentationProxy::~vtkSMInkStippleRepresentationProxy() = default;

int vtkSMInkStippleRepresentationProxy::ReadXMLAttributes(
  vtkSMSessionProxyManager* manager, vtkPVXMLElement* element)
{
  // There are not all properties yet.
  const vtkSMInkRestoring restoring(this);
  return this->Superclass::ReadXMLAttributes(manager, element);
}

void vtkSMInkStippleRepresentationProxy::SetPropertyModifiedFlag(const char* name, int flag)
{
  this->Superclass::SetPropertyModifiedFlag(name, flag);
  // Before there is an input the person's own defaults are read.
  if (!flag || !name || this->Restoring > 0 || vtkSMPropertyHelper(this, "Input").GetNumberOfElements() == 0)
  {
    return;
  }
  const vtkSMInkRestoring restoring(this);
  if (std::string(name) == PresetProperty)
  {
    this->FollowPreset();
  }
  else if (std::find(std::begin(Sliders), std::end(Sliders), std::string(name)) != std::end(Sliders))
  {
    this->FollowSlider(name);
  }
  for (const Start& start : Starts)
  {
    if (std::string(name) == start.Switch && IsOn(this, start) && IsUnset(this, start))
    {
      ChooseArray(this);
      start.Set(this, start.Property);
    }
  }
}

bool vtkSMInkStippleRepresentationProxy::IsAsFollowed(vtkSMProperty* property)
{
  auto proxy = vtkSMInkStippleRepresentationProxy::SafeDownCast(property->GetParent());
  return !proxy || !property->GetXMLName() || proxy->IsAsFollowed(std::string(property->GetXMLName()));
}

bool vtkSMInkStippleRepresentationProxy::IsAsFollowed(const std::string& name)
{
  const auto start = std::find_if(
    std::begin(Starts), std::end(Starts), [&](const Start& one) { return name == one.Property; });
  if (start != std::end(Starts))
  {
    return !IsOn(this, *start);
  }
  const std::vector<std::string> followers = this->GetFollowers();
  if (std::find(followers.begin(), followers.end(), name) == followers.end())
  {
    return true;
  }
  this->SetControls(std::find(std::begin(Sliders), std::end(Sliders), name) == std::end(Sliders));
  return Get(this, name) == ValueOf(this->Style, name);
}

void vtkSMInkStippleRepresentationProxy::FollowPreset()
{
  this->SetControls(false);
  for (const std::string& name : this->GetFollowers())
  {
    Set(this, name, ValueOf(this->Style, name));
  }
}

void vtkSMInkStippleRepresentationProxy::FollowSlider(const std::string& slider)
{
  this->SetControls(true);
  const std::vector<std::string> followers = this->GetFollowers();
  std::vector<const InkParameter*> parameters;
  for (const std::string& name : followers)
  {
    parameters.push_back(ParameterOf(this->Style, name));
  }
  const auto valuesAt = [&](double position)
  {
    ParameterOf(this->Style, slider)->Set(this->Style, { { position }, {} });
    std::vector<std::vector<double>> values;
    for (const InkParameter* parameter : parameters)
    {
      values.push_back(parameter->Get(this->Style).Numbers);
    }
    return values;
  };
  const auto low = valuesAt(0.0);
  const auto high = valuesAt(1.0);
  const auto here = valuesAt(vtkSMPropertyHelper(this, slider.c_str()).GetAsDouble());
  for (std::size_t i = 0; i < followers.size(); ++i)
  {
    // Only what the slider stands for: what was chosen for the others stays.
    if (followers[i] != slider && low[i] != high[i])
    {
      Set(this, followers[i], here[i]);
    }
  }
}

void vtkSMInkStippleRepresentationProxy::SetControls(bool sliders)
{
  const auto set = [&](const char* property)
  {
    const double number = vtkSMPropertyHelper(this, property).GetAsDouble();
    ParameterOf(this->Style, property)->Set(this->Style, { { number }, {} });
  };
  set(PresetProperty);
  if (sliders)
  {
    std::for_each(std::begin(Sliders), std::end(Sliders), set);
  }
}

std::vector<std::string> vtkSMInkStippleRepresentationProxy::GetFollowers()
{
  std::vector<std::string> names;
  const auto properties = vtkSmartPointer<vtkSMPropertyIterator>::Take(this->NewPropertyIterator());
  for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
  {
    vtkSMProperty* property = properties->GetProperty();
    const std::string name = properties->GetKey();
    const bool starts = std::any_of(std::begin(Starts), std::end(Starts),
      [&](const Start& start) { return name == start.Property || name == start.Switch; });
    const bool tracked = vtkSMInkIntVectorProperty::SafeDownCast(property) ||
      vtkSMInkDoubleVectorProperty::SafeDownCast(property);
    if (tracked && !starts && name != PresetProperty)
    {
      names.push_back(name);
    }
  }
  return names;
}
