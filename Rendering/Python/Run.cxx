// SPDX-License-Identifier: BSD-3-Clause

// The module pixelexact._run: long work from Python. VTK's wrapping keeps the interpreter's lock
// during Update(), and raises KeyboardInterrupt when the work is done.

#include "vtkPython.h" // before all others

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkPythonUtil.h"

#include <tbb/global_control.h>
#include <tbb/info.h>

#include <chrono>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace
{
using Clock = std::chrono::steady_clock;
// Often enough for a person, and seldom enough for other threads of the interpreter.
constexpr auto kBetweenLooks = std::chrono::milliseconds(30);

/// Tells Python of an algorithm's progress, and keeps what it complains of.
class Watch : public vtkCommand
{
public:
  static Watch* New() { return new Watch; }

  void Begin(vtkAlgorithm* algorithm, PyObject* callable)
  {
    Algorithm = algorithm;
    Callable = callable;
    algorithm->AddObserver(vtkCommand::ProgressEvent, this);
    algorithm->AddObserver(vtkCommand::ErrorEvent, this);
    algorithm->AddObserver(vtkCommand::WarningEvent, this);
    // It tells once more that the algorithm failed, and of inputs that are missing.
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
      this->Look(static_cast<const double*>(data));
    }
    else
    {
      auto& texts = event == vtkCommand::WarningEvent ? Warnings
        : caller == Algorithm                         ? Errors
                                                      : ExecutivesErrors;
      texts.emplace_back(static_cast<const char*>(data));
    }
  }

  /// Raises what was raised meanwhile, again. Whether there was something.
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

  std::vector<std::string> Errors;
  std::vector<std::string> ExecutivesErrors;
  std::vector<std::string> Warnings;

private:
  void Look(const double* done)
  {
    const Clock::time_point now = Clock::now();
    if (Type != nullptr || now - Last < kBetweenLooks)
    {
      return;
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
      Algorithm->SetAbortExecute(1);
    }
    PyGILState_Release(state);
  }

  vtkAlgorithm* Algorithm = nullptr;
  PyObject* Callable = nullptr;
  Clock::time_point Last;
  PyObject* Type = nullptr;
  PyObject* Value = nullptr;
  PyObject* Trace = nullptr;
};

/// Observers of these may be functions of Python, which VTK calls without asking for the lock.
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
  int informationAlone = 0;
  if (!PyArg_ParseTuple(arguments, "OOp|p", &object, &callable, &mayRelease, &informationAlone))
  {
    return nullptr;
  }
  auto* algorithm =
    static_cast<vtkAlgorithm*>(vtkPythonUtil::GetPointerFromObject(object, "vtkAlgorithm"));
  if (algorithm == nullptr)
  {
    return nullptr;
  }
  // Grids keep their models for all who ask, and do not expect several threads at once. Whoever
  // waits does so without the interpreter's lock, which progress and functions of Python need.
  // Recursive: these may ask for work, too.
  static std::recursive_mutex oneAtATime;
  std::unique_lock turn(oneAtATime, std::defer_lock);
  Py_BEGIN_ALLOW_THREADS;
  turn.lock();
  Py_END_ALLOW_THREADS;
  const bool release = mayRelease != 0 && !OthersListen(algorithm);
  const vtkNew<Watch> watch;
  watch->Begin(algorithm, callable);
  algorithm->SetAbortExecute(0);
  PyThreadState* const state = release ? PyEval_SaveThread() : nullptr;
  if (informationAlone != 0)
  {
    algorithm->UpdateInformation();
  }
  else
  {
    algorithm->Update();
  }
  if (release)
  {
    PyEval_RestoreThread(state);
  }
  watch->End();
  if (watch->Raise())
  {
    // What was given up is not to be taken for the result.
    algorithm->SetAbortExecute(0);
    algorithm->Modified();
    return nullptr;
  }
  return Py_BuildValue("NN",
    ListOf(watch->Errors.empty() ? watch->ExecutivesErrors : watch->Errors),
    ListOf(watch->Warnings));
}

PyObject* SetThreads(PyObject* /*module*/, PyObject* arguments)
{
  static std::unique_ptr<tbb::global_control> control;
  int count = 0;
  if (!PyArg_ParseTuple(arguments, "i", &count))
  {
    return nullptr;
  }
  // The least one counts, so that the former goes first.
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
    "update(algorithm, progress, may_release, information_only=False): errors and warnings of its "
    "Update(). progress is "
    "None or a function of the part that is done; what it raises, and KeyboardInterrupt, ends the "
    "work. The interpreter's lock is released unless may_release is false or others observe." },
  { "set_threads", SetThreads, METH_VARARGS, "set_threads(count): 0 for all processors." },
  { "get_threads", GetThreads, METH_NOARGS, "How many threads may work at once." },
  { nullptr, nullptr, 0, nullptr }
};

PyModuleDef definition = { PyModuleDef_HEAD_INIT, "_run", "Long work.", -1, methods, nullptr,
  nullptr, nullptr, nullptr };
} // namespace

PyMODINIT_FUNC PyInit__run();
PyMODINIT_FUNC PyInit__run()
{
  return PyModule_Create(&definition);
}
