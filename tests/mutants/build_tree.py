"""A build directory of Ninja. Compiles one changed source and links it, without a change in the directory."""

import json
import shlex
import subprocess
from pathlib import Path


class BuildFailed(Exception):
    """A command of the build failed. The text is its first error."""


def run_build_command(command, directory):
    done = subprocess.run(command, cwd=directory, capture_output=True, text=True, errors="replace", check=False)
    if done.returncode != 0:
        lines = (done.stderr or done.stdout).strip().splitlines()
        first = next((line for line in lines if "error" in line), lines[0] if lines else "no message")
        raise BuildFailed(first)
    return done.stdout


def after_option(command, option):
    return command.index(option) + 1


class BuildTree:
    def __init__(self, directory, root):
        self.directory = Path(directory)
        self.root = Path(root)
        entries = json.loads((self.directory / "compile_commands.json").read_text(encoding="utf-8"))
        self.compilations = {entry["file"]: shlex.split(entry["command"]) for entry in entries}
        self.links = {}

    def executable(self, name):
        return self.directory / "bin" / name

    def unit_of(self, source):
        """Returns the file that the build compiles for a source, and None.

        In a unity build this is the file that includes the source with others, and the line that includes it.
        """
        if source in self.compilations:
            return source, None
        line = f'#include "{source}"'
        for unit in self.compilations:
            if "/Unity/" in unit and line in Path(unit).read_text(encoding="utf-8").splitlines():
                return unit, line
        raise BuildFailed(f"{source} is not compiled in this build")

    @staticmethod
    def unit_with(unit, include, mutant, folder):
        """Writes a copy of the unit that includes the mutant instead of the source, and returns its path.

        Its object defines all symbols of the library's object.
        """
        copy = folder / f"unit_{Path(unit).name}"
        copy.write_text(Path(unit).read_text(encoding="utf-8").replace(include, f'#include "{mutant}"'), encoding="utf-8")
        return copy

    def embedded(self, source, copy, folder):
        """Returns the C++ source that the build makes of an embedded text, and the source that it makes of the copy."""
        query = run_build_command(["ninja", "-t", "query", source], self.directory).splitlines()
        output = next((line.strip() for line in query if line.endswith(".cpp")), None)
        if output is None:
            raise BuildFailed(f"{source} is not embedded in this build")
        command = run_build_command(["ninja", "-t", "commands", output], self.directory).splitlines()[-1]
        words = [word.replace(source, str(copy)) for word in shlex.split(command.split("&&", 1)[1])]
        target = folder / Path(output).name
        words = [f"OUTPUT={target}" if word.startswith("OUTPUT=") else word for word in words]
        run_build_command(words, self.directory)
        return str(self.directory / output), target

    def compile(self, file, text, folder):
        """Compiles `text` instead of the source or embedded text `file`. Returns the object.

        Includes are named from the root, so that the copy may lie anywhere.
        """
        source = str(self.root / file)
        copy = folder / Path(file).name
        copy.write_text(text, encoding="utf-8")
        if copy.suffix == ".txt":
            source, copy = self.embedded(source, copy, folder)
        unit, include = self.unit_of(source)
        if include:
            source, copy = unit, self.unit_with(unit, include, copy, folder)
        target = folder / (copy.name + ".o")
        # A mutant may leave a variable unused.
        command = [word for word in self.compilations[source] if word != "-Werror"]
        command[after_option(command, "-o")] = str(target)
        command[after_option(command, "-c")] = str(copy)
        run_build_command(command, self.directory)
        return target

    def link_command(self, name):
        if name not in self.links:
            output = f"bin/{name}"
            commands = run_build_command(["ninja", "-t", "commands", output], self.directory).splitlines()
            line = commands[-1].removeprefix(": && ").removesuffix(" && :")
            if f"-o {output}" not in line:
                raise BuildFailed(f"the last command for {output} does not link it")
            self.links[name] = shlex.split(line)
        return self.links[name]

    def contains(self, name, file):
        """True if the library of this source is linked into the executable."""
        library = f"libsteadyslide_{file.split('/')[0]}.a"
        return any(word.endswith(library) for word in self.link_command(name))

    def link(self, name, mutated_object, folder):
        """Links the executable with the object before the libraries, so that its symbols replace theirs."""
        command = list(self.link_command(name))
        target = folder / name
        command[after_option(command, "-o")] = str(target)
        first_library = next(k for k, word in enumerate(command) if word.endswith(".a"))
        command.insert(first_library, str(mutated_object))
        run_build_command(command, self.directory)
        return target
