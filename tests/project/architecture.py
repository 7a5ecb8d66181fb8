"""architecture.py SOURCE: checks that docs/architecture.md agrees with the sources.

- Includes follow the arrows between layers, and within a layer the order of its folders in the page.
- GiNaC and CLN stay in sources and in the headers declared here.
- Every folder of a layer is on the page. Every folder, file and name on the page exists.
"""
import re
import sys
from fnmatch import fnmatch
from pathlib import Path

witnesses = ["symbolic", "numeric", "enclosure"]
may_include = {
    "model": ["model"],
    **{witness: ["model", witness] for witness in witnesses},
    "library": ["model", *witnesses, "library"],
    "proofs_checks": ["model", *witnesses, "proofs_checks"],
    "app": ["model", *witnesses, "library", "proofs_checks", "app"],
    "checker": ["checker"],
    "bindings/explorer": ["model", "numeric", "library"],
}
# It sorts the claims in the order of the paper's statements.
may_include_later_folders = ["proofs_checks/kit/registry.cpp"]
# ginac.h and CLN's headers cost a second for each file and define macros. Only sources of these layers and these
# headers include them; built_with.cpp uses only their versions.
algebra_in_sources_of = ["symbolic", "proofs_checks"]
algebra_headers = """app/report/built_with.cpp symbolic/cln/cln_number.hpp symbolic/coq/coq_equation.hpp
    symbolic/field/expression.hpp symbolic/field/field_linear.hpp symbolic/field/phase_field.hpp
    symbolic/field/rational_function.hpp symbolic/field/written_identity.hpp symbolic/local/coupling.hpp
    symbolic/local/local_action.hpp symbolic/local/local_form.hpp symbolic/local/local_place.hpp
    symbolic/local/polynomial_slope.hpp symbolic/statements/local_form_check.hpp
    symbolic/statements/polynomial_families.hpp symbolic/statements/written_expression.hpp
    symbolic/statements/written_functions.hpp symbolic/statements/written_statements.hpp""".split()

source = Path(sys.argv[1])
visible = [path for path in source.iterdir() if path.name != "build" and not path.name.startswith(".")]
files = [str(path.relative_to(source)) for top in visible for path in [top, *top.glob("**/*")]
         if path.is_file() and path.suffix != ".pyc"]
page_name = "docs/architecture.md"
page = (source / page_name).read_text()
wrong = []


def in_backticks(text):
    return re.findall(r"`([^`]+)`", text)


def matches(path, word):
    """True if the path ends with the word, where <...> stands for any name; if the word ends with /, for a folder."""
    return fnmatch(f"/{path}", "*/" + re.sub("<.*?>", "*", word))


# For each layer the folders in its row, with / at the end.
section = page.partition("\n## Folders\n")[2].partition("\n## ")[0]
rows = {layer: [word for word in in_backticks(row) if word.endswith("/")]
        for layer, row in re.findall(r"^\| `(\w+)/` \| (.*) \|$", section, re.MULTILINE)}


def position(layer, path):
    """Returns the position of the path's folder in the row of the layer; -1 for a path that is in none of them."""
    row = rows.get(layer, [])
    folder = path.removeprefix(f"{layer}/").partition("/")[0] + "/"
    return row.index(folder) if folder in row else -1


def check_include(layer, file, header):
    top = header.split("/")[0] if "/" in header else ""
    if ".." in header.split("/"):
        wrong.append(f"{file} includes {header}: headers are named from the root")
    elif top == "tests" or top in may_include and top not in may_include[layer]:
        wrong.append(f"{file} includes {header}: {layer} does not include {top}")
    elif (top == layer and -1 < position(layer, file) < position(layer, header)
          and file not in may_include_later_folders):
        wrong.append(f"{file} includes {header}: its folder comes later in {page_name}")
    elif (top in ["ginac", "cln"] and file not in algebra_headers
          and not (layer in algebra_in_sources_of and file.endswith(".cpp"))):
        wrong.append(f"{file} includes {header}: GiNaC and CLN stay in sources and in the headers declared here")


count = 0
for layer in may_include:
    if f"`{layer}/`" not in page:
        wrong.append(f"{layer}/ is not in {page_name}")
    for file in (file for file in files if file.startswith(f"{layer}/")):
        folder = file.rpartition("/")[0] + "/"
        is_listed = "/" in layer or folder == f"{layer}/" or any(matches(folder, word) for word in rows.get(layer, []))
        if not is_listed:
            wrong.append(f"{folder} is not in the row of {layer}/ in {page_name}")
        if not file.endswith((".hpp", ".cpp")):
            continue
        count += 1
        for line in re.findall(r"^[ \t]*#[ \t]*include.*$", (source / file).read_text(), re.MULTILINE):
            header = re.search(r'include[ \t]*[<"]([^>"]+)[>"]', line)
            if header:
                check_include(layer, file, header[1])
            else:
                wrong.append(f"{file}: unreadable: {line}")
if count == 0:
    sys.exit(f"no file found under {source}")

folders = {file[:end + 1] for file in files for end in range(len(file)) if file[end] == "/"}
for layer, row in rows.items():
    wrong += [f"{page_name}: {layer}/ has no {word}" for word in row
              if not any(matches(folder, word) for folder in folders if folder.startswith(f"{layer}/"))]
texts = "".join((source / file).read_text(errors="ignore") for file in files
                if file.endswith((".txt", ".cmake", ".cpp", ".hpp", ".py", ".md")) and file != page_name)
for word in {part for words in in_backticks(page) for part in re.split('[ ="(]', words)}:
    is_path = "/" in word or re.search(r"\.(cpp|hpp|md|py|txt|toml|json|cmake)$", word)
    if not (any(matches(path, word.removeprefix("./")) for path in [*files, *folders]) if is_path else word in texts):
        wrong.append(f"{page_name}: {word} does not exist")

if wrong:
    sys.exit("\n".join(sorted(set(wrong))))
print(f"{count} files, no arrow reversed, all folders of the layers in {page_name}")
