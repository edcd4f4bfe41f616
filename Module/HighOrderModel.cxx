// SPDX-License-Identifier: BSD-3-Clause
#include "HighOrderModel.h"

#include "ArrayViews.h"
#include "CompositeParts.h"
#include "ConversionLoss.h"
#include "Core/Base/Error.h"
#include "Core/Expression/Expression.h"
#include "Core/Expression/Program.h"
#include "ElementMeasures.h"
#include "Fingerprint.h"
#include "JoinedArrays.h"
#include "MeshPart.h"
#include "PackedArrays.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <mutex>
#include <optional>
#include <set>

namespace pixelexact
{
namespace
{
/// Copies a cell array with one value per cell; returns zeros where there is none.
std::vector<std::uint8_t> MarksOf(vtkUnstructuredGrid* grid, const char* name)
{
  vtkDataArray* array = grid->GetCellData()->GetArray(name);
  std::vector<std::uint8_t> marks(static_cast<std::size_t>(grid->GetNumberOfCells()), 0);
  if (array != nullptr && array->GetNumberOfValues() == grid->GetNumberOfCells())
  {
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
    {
      marks[static_cast<std::size_t>(cell)] =
        static_cast<std::uint8_t>(array->GetComponent(cell, 0));
    }
  }
  return marks;
}

/// Returns the array kSelectedCells; empty where there is none.
std::vector<std::int64_t> SelectedCellsOf(vtkUnstructuredGrid* grid)
{
  vtkDataArray* array = grid->GetCellData()->GetArray(kSelectedCells);
  std::vector<std::int64_t> cells;
  if (array != nullptr && array->GetNumberOfValues() == grid->GetNumberOfCells())
  {
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
    {
      cells.push_back(static_cast<std::int64_t>(array->GetComponent(cell, 0)));
    }
  }
  return cells;
}

/// Collects the names that expressions may use besides fields, from the grid's FieldData and its
/// time.
ExpressionScope NamesOf(vtkUnstructuredGrid* grid)
{
  ExpressionScope scope;
  vtkFieldData* data = grid->GetFieldData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    const std::string name =
      array != nullptr && array->GetName() != nullptr ? array->GetName() : "";
    if (array == nullptr || array->GetNumberOfValues() != 1)
    {
      continue;
    }
    if (auto* text = vtkStringArray::SafeDownCast(array))
    {
      if (name.starts_with(kDefinitionPrefix))
      {
        scope.definitions[name.substr(std::string(kDefinitionPrefix).size())] = text->GetValue(0);
      }
    }
    else if (auto* number = vtkDataArray::SafeDownCast(array);
             number != nullptr && !name.starts_with("PixelExact"))
    {
      scope.parameters[name] = number->GetComponent(0, 0);
    }
  }
  vtkInformation* information = grid->GetInformation();
  if (information->Has(vtkDataObject::DATA_TIME_STEP()))
  {
    scope.time = information->Get(vtkDataObject::DATA_TIME_STEP());
  }
  return scope;
}

/// Models in use, by their data: a filter, a mapper and the grid itself share one.
struct Registry
{
  std::mutex mutex;
  std::map<const vtkDataObject*, std::weak_ptr<HighOrderModel>> models;

  static Registry& Instance()
  {
    static Registry registry;
    return registry;
  }
};

/// Throws where an expression uses derivatives or det J, which the solids beneath a surface in
/// space do not have from the source.
void RequireNoDerivatives(const std::string& text, const FieldExpression& expression)
{
  for (const Graph::Node& leaf : expression.GetProgram().Leaves())
  {
    const auto is = [&leaf](Operation operation) { return leaf.operation == operation; };
    if (is(Operation::InverseJacobian) || is(Operation::Determinant) ||
      is(Operation::ScaledJacobian) || is(Operation::Slope) || is(Operation::Curvature) ||
      is(Operation::Behind))
    {
      throw Unsupported("'" + text +
        "' uses derivatives, det J or jumps, which are not available on a surface in space; use "
        "values of fields alone");
    }
  }
}
} // namespace

struct HighOrderModel::Internals
{
  std::shared_ptr<const MeshPart> part;
  ViewStorage storage;
  std::vector<Field> fields;
  std::vector<Block> blocks;
  std::vector<std::uint8_t> ghosts;   ///< by element, VTK's marks
  std::vector<std::uint8_t> inner;    ///< by element, kInnerFaces
  std::vector<std::int64_t> selected; ///< by element, kSelectedCells; empty: the source's
  DataState state;
  ExpressionScope names; ///< without fields and numbers
  std::mutex making;
  std::map<std::string, Field> made; ///< of expressions, by their text
  std::optional<ElementMeasures> measures;

  /// The measures that an expression names, and that are not the names of something else.
  [[nodiscard]] std::set<std::string> MeasuresNamedIn(const std::string& text) const
  {
    std::set<std::string> found = ElementMeasures::NamedIn(text, names.definitions);
    std::erase_if(found,
      [this](const std::string& name)
      {
        return names.definitions.contains(name) || names.parameters.contains(name) ||
          std::ranges::find(fields, name, &Field::name) != fields.end();
      });
    return found;
  }

  void AddField(vtkUnstructuredGrid* source, const std::string& name)
  {
    const std::string prefix = kFieldPrefix + name + ".";
    const vtkIdType elements = part->StoredElements();
    auto& keeper = storage.arrays;
    const auto view = ViewExpansion(source, prefix, elements, keeper);
    const int components = ViewArray<std::int32_t>(source, prefix + "Components", 1, 1, keeper)[0];
    if (view.origin != Origin::Coefficients)
    {
      const auto prints =
        ViewArray<std::int64_t>(source, prefix + "Fingerprint", 1, elements, keeper);
      // An array that a filter dropped cannot have been changed.
      if (vtkDataArray* nodal = FieldSource(source, name, view.origin))
      {
        part->Cells().Compare(
          source, [&](Hash hash) { return ValueFingerprints(source, nodal, view.origin, hash); },
          prints,
          "has other values of '" + name + "' than its coefficients: the array was changed");
      }
    }
    Field& field = fields.emplace_back();
    field.name = name;
    field.values = storage.Assemble(view, part->Cells(), components);
    field.mapping = ReadMapping(source, prefix);
    Validate(field, part->GetMesh());
  }
};

HighOrderModel::HighOrderModel(vtkUnstructuredGrid* given)
  : Data(std::make_unique<Internals>())
{
  if (!HasHighOrderArrays(given))
  {
    const bool isLinear = given != nullptr && OrderLostByConversion(given) >= 0;
    throw InvalidData("the grid carries no high-order coefficients" +
      (isLinear ? RemedyOf(given) : "; pass it through vtkUnstructuredGridToHighOrderGrid first."));
  }
  Data->state = StateOf(given);
  Data->names = NamesOf(given);
  Data->ghosts = MarksOf(given, vtkDataSetAttributes::GhostArrayName());
  Data->inner = MarksOf(given, kInnerFaces);
  Data->selected = SelectedCellsOf(given);
  const auto grid = IsPacked(given) ? Unpack(given) : vtkSmartPointer<vtkUnstructuredGrid>(given);
  Data->part = MeshPart::Of(grid);
  Data->measures.emplace(Data->part->GetMesh());
  Data->measures->Read(given);
  for (const auto& name : StoredFieldNames(grid))
  {
    Data->AddField(grid, name);
  }
}

HighOrderModel::HighOrderModel(vtkCompositeDataSet* data)
  : Data(std::make_unique<Internals>())
{
  Data->state = StateOf(data);
  std::vector<std::shared_ptr<HighOrderModel>> models;
  std::vector<std::shared_ptr<const MeshPart>> parts;
  std::int64_t elements = 0;
  for (const CompositePart& part : PartsOf(data))
  {
    try
    {
      models.push_back(std::shared_ptr<HighOrderModel>(new HighOrderModel(part.grid)));
    }
    catch (const Error& error)
    {
      throw InvalidData(part.name + ": " + error.what());
    }
    parts.push_back(models.back()->Data->part);
    Data->blocks.push_back({ part.flatIndex, elements });
    const Internals& leaf = *models.back()->Data;
    Data->ghosts.insert(Data->ghosts.end(), leaf.ghosts.begin(), leaf.ghosts.end());
    Data->inner.insert(Data->inner.end(), leaf.inner.begin(), leaf.inner.end());
    elements += models.back()->GetMesh().Elements();
  }
  if (parts.empty())
  {
    throw InvalidData("the composite data hold no cells.");
  }
  if (std::ranges::any_of(models, [](const auto& model) { return !model->Data->selected.empty(); }))
  {
    for (const auto& model : models)
    {
      const auto cells = model->SelectedCells();
      Data->selected.insert(Data->selected.end(), cells.begin(), cells.end());
    }
  }
  Data->part = MeshPart::Join(std::move(parts));
  Data->measures.emplace(GetMesh());
  for (const auto& model : models)
  {
    Data->measures->Append(*model->Data->measures);
  }
  Data->names = models.front()->Data->names;
  for (const Field& first : models.front()->Data->fields)
  {
    std::vector<const Expansion*> values;
    for (const auto& model : models)
    {
      const Field* field = model->FindField(first.name);
      if (field != nullptr && field->mapping == first.mapping &&
        field->values.components == first.values.components)
      {
        values.push_back(&field->values);
      }
    }
    if (values.size() == models.size())
    {
      Field& field = Data->fields.emplace_back(first);
      field.values = Join(values, Data->storage);
      Validate(field, GetMesh());
    }
  }
  if (Data->fields.empty() && !models.front()->Data->fields.empty())
  {
    throw InvalidData("the blocks have no high-order field in common, with as many components.");
  }
}

HighOrderModel::~HighOrderModel() = default;

std::shared_ptr<HighOrderModel> HighOrderModel::From(vtkDataObject* data)
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    return From(grid);
  }
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (composite == nullptr)
  {
    throw InvalidData(
      std::string("there is no high-order grid, but ") + (data ? data->GetClassName() : "nothing"));
  }
  return Shared(data, composite);
}

/// Returns null where no caller holds the model. The registry must be locked.
std::shared_ptr<HighOrderModel> HighOrderModel::Known(vtkDataObject* data)
{
  auto& models = Registry::Instance().models;
  std::erase_if(models, [](const auto& entry) { return entry.second.expired(); });
  const auto known = models.find(data);
  auto model = known != models.end() ? known->second.lock() : nullptr;
  return model && model->IsCurrent(data) ? model : nullptr;
}

std::shared_ptr<HighOrderModel> HighOrderModel::From(vtkUnstructuredGrid* grid)
{
  return Shared(grid, grid);
}

template <class Source>
std::shared_ptr<HighOrderModel> HighOrderModel::Shared(vtkDataObject* key, Source* source)
{
  auto& registry = Registry::Instance();
  const std::scoped_lock lock(registry.mutex);
  auto model = Known(key);
  if (!model)
  {
    model.reset(new HighOrderModel(source));
    registry.models[key] = model;
  }
  return model;
}

const Mesh& HighOrderModel::GetMesh() const
{
  return Data->part->GetMesh();
}

std::span<const Field> HighOrderModel::Fields() const
{
  return Data->fields;
}

const Field& HighOrderModel::GetField(const std::string& text) const
{
  const bool isQuoted =
    text.size() > 2 && text.front() == text.back() && (text.front() == '"' || text.front() == '\'');
  for (const std::string& name : { text, isQuoted ? text.substr(1, text.size() - 2) : text })
  {
    if (const auto found = std::ranges::find(Data->fields, name, &Field::name);
        found != Data->fields.end())
    {
      return *found;
    }
  }
  const std::scoped_lock lock(Data->making);
  Field& field = Data->made[text];
  if (!field.name.empty())
  {
    return field;
  }
  ExpressionScope scope = Data->names;
  scope.fields = Data->fields;
  scope.numbers = SourceCells();
  scope.locator = [part = Data->part.get()]() -> const Locator& { return part->GetLocator(); };
  const auto defined = scope.definitions.find(text);
  try
  {
    if (const std::set<std::string> measures = Data->MeasuresNamedIn(text); !measures.empty())
    {
      scope.fields = Data->measures->With(Data->fields, measures);
      if (measures.contains(text))
      {
        return field = scope.fields.back();
      }
    }
    const auto expression =
      MakeExpression(defined == scope.definitions.end() ? text : defined->second, scope);
    if (IsShell())
    {
      RequireNoDerivatives(text, *expression);
    }
    field.function = expression;
  }
  catch (const InvalidData& error)
  {
    Data->made.erase(text);
    const bool isUnknown = std::string(error.what()).starts_with("nothing is named '" + text + "'");
    const bool isName = isUnknown || text.find(' ') != std::string::npos;
    if (IsMoreThanName(text) || defined != scope.definitions.end() || !isName)
    {
      throw;
    }
    throw InvalidData("there is no field '" + text + "'; " + NamesOfFields());
  }
  catch (const Error&)
  {
    Data->made.erase(text);
    throw;
  }
  field.name = text;
  field.values.components = field.function->Components();
  return field;
}

const std::map<std::string, std::string>& HighOrderModel::Definitions() const
{
  return Data->names.definitions;
}

const std::map<std::string, double>& HighOrderModel::Parameters() const
{
  return Data->names.parameters;
}

const Field* HighOrderModel::FindField(const std::string& text) const
{
  try
  {
    return &GetField(text);
  }
  catch (const Error&)
  {
    return nullptr;
  }
}

std::string HighOrderModel::NamesOfFields() const
{
  std::string names;
  const auto add = [&names](const std::string& name)
  { names += (names.empty() ? "choose one of '" : ", '") + name + "'"; };
  for (const Field& field : Fields())
  {
    add(field.name);
  }
  for (const auto& [name, text] : Definitions())
  {
    add(name);
  }
  return names.empty() ? "there are no fields" : names + ", or an expression of them";
}

const Locator& HighOrderModel::GetLocator() const
{
  return Data->part->GetLocator();
}

bool HighOrderModel::HasLocator() const
{
  return Data->part->HasLocator();
}

const FaceTable& HighOrderModel::Faces() const
{
  return Data->part->GetFaces();
}

bool HighOrderModel::HasFaces() const
{
  return Data->part->HasFaces();
}

std::span<const std::int64_t> HighOrderModel::SourceCells() const
{
  return Data->part->SourceCells();
}

std::span<const std::int64_t> HighOrderModel::SelectedCells() const
{
  return Data->selected.empty() ? SourceCells() : Data->selected;
}

bool HighOrderModel::IsShell() const
{
  return GetMesh().isShell;
}

void HighOrderModel::RequireSolids(const std::string& what) const
{
  if (IsShell())
  {
    throw Unsupported(what +
      ": the mesh is a surface in space, without a volume; only the boundary (--boundary) shows "
      "it");
  }
}

std::span<const AttributedFace> HighOrderModel::BoundaryFaces() const
{
  return Data->part->BoundaryFaces();
}

std::span<const HighOrderModel::Block> HighOrderModel::Blocks() const
{
  return Data->blocks;
}

const HighOrderModel::Block& HighOrderModel::BlockOf(
  std::int64_t element, std::span<const Block> blocks)
{
  const auto after = std::ranges::upper_bound(blocks, element, {}, &Block::begin);
  return *std::prev(after);
}

bool HighOrderModel::IsGhost(int element) const
{
  return (Data->ghosts[static_cast<std::size_t>(element)] & vtkDataSetAttributes::DUPLICATECELL) !=
    0;
}

bool HighOrderModel::IsInner(int element, int face) const
{
  return (Data->inner[static_cast<std::size_t>(element)] >> static_cast<unsigned>(face) & 1U) != 0;
}

bool HighOrderModel::IsCurrent(vtkDataObject* data) const
{
  return data == Data->state.front().first && StateOf(data) == Data->state;
}
} // namespace pixelexact
