// SPDX-License-Identifier: BSD-3-Clause

// The module pixelexact._run: long work from Python, and the files that the program reads. VTK's
// wrapping keeps the interpreter's lock during Update(), and raises KeyboardInterrupt when the work
// is done.

#include "vtkPython.h" // before all others

#include "Base/Command.h"
#include "Input/Input.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkPythonUtil.h"
#include "vtkUnstructuredGrid.h"

#include <tbb/global_control.h>
#include <tbb/info.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace
{
using Clock = std::chrono::steady_clock;
// Often enough for users, and seldom enough for other threads of the interpreter.
constexpr auto kPollInterval = std::chrono::milliseconds(30);

/// Serialises work, because grids share their models and do not support several threads at once. A
/// waiting thread releases the interpreter's lock, which Python progress functions and callbacks
/// need. Recursive, because these may start work.
std::unique_lock<std::recursive_mutex> TakeTurn()
{
  static std::recursive_mutex oneAtATime;
  std::unique_lock turn(oneAtATime, std::defer_lock);
  Py_BEGIN_ALLOW_THREADS;
  turn.lock();
  Py_END_ALLOW_THREADS;
  return turn;
}

/// Calls a Python progress function with the completed part, at most once per kPollInterval, and
/// checks for signals.
class ProgressCall
{
public:
  explicit ProgressCall(PyObject* callable = Py_None)
    : Callable(callable)
  {
  }

  /// Returns false if the work must end. Works with the interpreter's lock or without. `done` may
  /// be null.
  bool Look(const double* done)
  {
    const Clock::time_point now = Clock::now();
    if (Type != nullptr || now - Last < kPollInterval)
    {
      return Type == nullptr;
    }
    Last = now;
    const PyGILState_STATE state = PyGILState_Ensure();
    bool goOn = PyErr_CheckSignals() == 0;
    if (goOn && Callable != Py_None && done != nullptr)
    {
      PyObject* answer = PyObject_CallFunction(Callable, "d", *done);
      goOn = answer != nullptr;
      Py_XDECREF(answer);
    }
    if (!goOn)
    {
      PyErr_Fetch(&Type, &Value, &Trace);
    }
    PyGILState_Release(state);
    return goOn;
  }

  /// Raises the exception that the function or a signal caused. Returns false if there is none.
  bool Raise()
  {
    if (Type == nullptr)
    {
      return false;
    }
    PyErr_Restore(Type, Value, Trace);
    Type = Value = Trace = nullptr;
    return true;
  }

private:
  PyObject* Callable;
  Clock::time_point Last;
  PyObject* Type = nullptr;
  PyObject* Value = nullptr;
  PyObject* Trace = nullptr;
};

/// Reports an algorithm's progress to Python, and stores its errors and warnings.
class Watch : public vtkCommand
{
public:
  static Watch* New() { return new Watch; }

  void Begin(vtkAlgorithm* algorithm, PyObject* callable)
  {
    Algorithm = algorithm;
    Call = ProgressCall(callable);
    algorithm->AddObserver(vtkCommand::ProgressEvent, this);
    algorithm->AddObserver(vtkCommand::ErrorEvent, this);
    algorithm->AddObserver(vtkCommand::WarningEvent, this);
    // The executive reports the failure a second time, and also missing inputs.
    algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this);
  }

  void End()
  {
    Algorithm->RemoveObserver(this);
    Algorithm->GetExecutive()->RemoveObserver(this);
  }

  void Execute(vtkObject* caller, unsigned long event, void* data) override
  {
    if (event == vtkCommand::ProgressEvent)
    {
      if (!Call.Look(static_cast<const double*>(data)))
      {
        Algorithm->SetAbortExecute(1);
      }
    }
    else
    {
      auto& texts = event == vtkCommand::WarningEvent ? Warnings
        : caller == Algorithm                         ? Errors
                                                      : ExecutivesErrors;
      texts.emplace_back(static_cast<const char*>(data));
    }
  }

  ProgressCall Call;
  std::vector<std::string> Errors;
  std::vector<std::string> ExecutivesErrors;
  std::vector<std::string> Warnings;

private:
  vtkAlgorithm* Algorithm = nullptr;
};

/// Observers of these may be Python functions, which VTK calls without acquiring the interpreter's
/// lock.
bool OthersListen(vtkAlgorithm* algorithm)
{
  vtkOutputWindow* window = vtkOutputWindow::GetInstance();
  return algorithm->HasObserver(vtkCommand::AnyEvent) || window->HasObserver(vtkCommand::AnyEvent);
}

PyObject* ListOf(const std::vector<std::string>& texts)
{
  PyObject* list = PyList_New(0);
  for (const std::string& text : texts)
  {
    PyObject* item =
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace");
    PyList_Append(list, item);
    Py_DECREF(item);
  }
  return list;
}

PyObject* Update(PyObject* /*module*/, PyObject* arguments)
{
  PyObject* object = nullptr;
  PyObject* callable = Py_None;
  int mayRelease = 1;
  if (!PyArg_ParseTuple(arguments, "OOp", &object, &callable, &mayRelease))
  {
    return nullptr;
  }
  auto* algorithm =
    static_cast<vtkAlgorithm*>(vtkPythonUtil::GetPointerFromObject(object, "vtkAlgorithm"));
  if (algorithm == nullptr)
  {
    return nullptr;
  }
  const auto turn = TakeTurn();
  const bool release = mayRelease != 0 && !OthersListen(algorithm);
  const vtkNew<Watch> watch;
  watch->Begin(algorithm, callable);
  algorithm->SetAbortExecute(0);
  PyThreadState* const state = release ? PyEval_SaveThread() : nullptr;
  algorithm->Update();
  if (release)
  {
    PyEval_RestoreThread(state);
  }
  watch->End();
  if (watch->Call.Raise())
  {
    // An aborted output must not be taken for a result, so the next Update repeats the work.
    algorithm->SetAbortExecute(0);
    algorithm->Modified();
    return nullptr;
  }
  return Py_BuildValue("NN",
    ListOf(watch->Errors.empty() ? watch->ExecutivesErrors : watch->Errors),
    ListOf(watch->Warnings));
}

/// Sets the files of an InputRequest. Returns false, with a Python exception set, for other
/// arguments.
bool ParseFiles(PyObject* list, pixelexact::InputRequest& request)
{
  const Py_ssize_t count = PySequence_Size(list);
  for (Py_ssize_t i = 0; i < count; ++i)
  {
    PyObject* item = PySequence_GetItem(list, i);
    PyObject* bytes = nullptr;
    if (item != nullptr && PyUnicode_FSConverter(item, &bytes) != 0)
    {
      request.files.emplace_back(PyBytes_AsString(bytes));
      Py_DECREF(bytes);
    }
    Py_XDECREF(item);
  }
  if (PyErr_Occurred() == nullptr && request.files.empty())
  {
    PyErr_SetString(PyExc_ValueError, "no file is named");
  }
  return PyErr_Occurred() == nullptr;
}

PyObject* cannotRead = nullptr; ///< the exception of that name

/// Does `work` without the interpreter's lock. Returns false with a Python exception set:
/// ValueError for files that do not belong together or have no reader, CannotRead for files that
/// cannot be read.
template <class Work>
bool ReadFiles(const Work& work)
{
  const auto turn = TakeTurn();
  // Readers' messages are in exceptions. Restores VTK's messages, which the program's reading
  // silences.
  const auto verbosity =
    std::min(vtkLogger::GetCurrentVerbosityCutoff(), vtkLogger::VERBOSITY_INFO);
  std::string error;
  PyObject* kind = nullptr;
  PyThreadState* const state = PyEval_SaveThread();
  try
  {
    work();
  }
  catch (const pixelexact::UsageError& usage)
  {
    kind = PyExc_ValueError;
    error = usage.what();
  }
  catch (const pixelexact::UnknownFormat& unknown)
  {
    kind = PyExc_ValueError;
    error = unknown.what();
  }
  catch (const std::exception& other)
  {
    kind = cannotRead;
    error = other.what();
  }
  vtkLogger::SetStderrVerbosity(verbosity);
  PyEval_RestoreThread(state);
  if (kind != nullptr)
  {
    PyErr_SetString(kind, error.c_str());
  }
  return kind == nullptr;
}

PyObject* Read(PyObject* /*module*/, PyObject* arguments)
{
  PyObject* files = nullptr;
  PyObject* callable = Py_None;
  int step = 0;
  int cornerCells = 0;
  int surfaceElements = 0;
  pixelexact::InputRequest request;
  if (PyArg_ParseTuple(
        arguments, "OippO", &files, &step, &cornerCells, &surfaceElements, &callable) == 0 ||
    !ParseFiles(files, request))
  {
    return nullptr;
  }
  request.step = step;
  request.cornerCells = cornerCells != 0;
  request.surfaceElements = surfaceElements != 0;
  ProgressCall call(callable);
  pixelexact::InputGrid input;
  const bool isRead = ReadFiles(
    [&]
    {
      const pixelexact::ReadListener listener([&call](double done) { return call.Look(&done); });
      input = pixelexact::ReadInput(request);
    });
  if (call.Raise() || !isRead)
  {
    return nullptr;
  }
  return Py_BuildValue("NN", vtkPythonUtil::GetObjectFromPointer(input.grid), ListOf(input.notes));
}

PyObject* Times(PyObject* /*module*/, PyObject* files)
{
  pixelexact::InputRequest request;
  std::vector<double> times;
  if (!ParseFiles(files, request) || !ReadFiles([&] { times = pixelexact::ReadTimes(request); }))
  {
    return nullptr;
  }
  PyObject* list = PyList_New(0);
  for (const double time : times)
  {
    PyObject* item = PyFloat_FromDouble(time);
    PyList_Append(list, item);
    Py_DECREF(item);
  }
  return list;
}

PyObject* SetThreads(PyObject* /*module*/, PyObject* arguments)
{
  static std::unique_ptr<tbb::global_control> control;
  int count = 0;
  if (!PyArg_ParseTuple(arguments, "i", &count))
  {
    return nullptr;
  }
  // TBB uses the least of all limits, so the previous limit is removed first.
  control.reset();
  if (count > 0)
  {
    control = std::make_unique<tbb::global_control>(
      tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count));
  }
  Py_RETURN_NONE;
}

PyObject* GetThreads(PyObject* /*module*/, PyObject* /*arguments*/)
{
  return PyLong_FromSize_t(
    tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

PyMethodDef methods[] = {
  { "update", Update, METH_VARARGS,
    "update(algorithm, progress, may_release): errors and warnings of its Update(). progress is "
    "None or a function of the completed part; what it raises, and KeyboardInterrupt, ends the "
    "work. The interpreter's lock is released unless may_release is false or others observe." },
  { "read", Read, METH_VARARGS,
    "read(files, step, corner_cells, surface_elements, progress): the grid and notes on it, as the "
    "program reads INPUT." },
  { "times", Times, METH_O, "times(files): the times of their steps, ascending." },
  { "set_threads", SetThreads, METH_VARARGS, "set_threads(count): 0 for all processors." },
  { "get_threads", GetThreads, METH_NOARGS, "The largest number of threads that work at once." },
  { nullptr, nullptr, 0, nullptr }
};

PyModuleDef definition = { PyModuleDef_HEAD_INIT, "_run", "Long work.", -1, methods, nullptr,
  nullptr, nullptr, nullptr };
} // namespace

PyMODINIT_FUNC PyInit__run();
PyMODINIT_FUNC PyInit__run()
{
  PyObject* module = PyModule_Create(&definition);
  cannotRead = PyErr_NewException("pixelexact._run.CannotRead", PyExc_RuntimeError, nullptr);
  Py_XINCREF(cannotRead);
  PyModule_AddObject(module, "CannotRead", cannotRead);
  return module;
}
