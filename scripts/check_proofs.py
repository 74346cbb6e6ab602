"""Check docs/proofs with Coq and print the table entry, theorem, assumptions: those of theorems together, or with --each of each by itself.

The files are copied to target/proofs and compiled there. Then, from docs/proofs and, for the tables of theorems and steps,
crates/mdr-symbolic/data, where `mdr derive` reads it:
  theorems.tsv     every theorem it names exists and has been checked; every theorem of the files is named
  assumptions.txt  no theorem rests on anything that is not listed there
  left_out.tsv     every statement of Statements.v that normal forms prove is proved in Steps.v or named here
  by_theorem.tsv   the statements that StepTheorems.v proves besides, and the theorems they follow from
  mutants.tsv      a statement with one change in it is refused, at that statement and not elsewhere
"""

import concurrent.futures
import hashlib
import pathlib
import re
import shutil
import subprocess
import sys

SOURCE = pathlib.Path("docs/proofs")
THEOREMS = pathlib.Path("crates/mdr-symbolic/data")
BUILD = pathlib.Path("target/proofs")
FLAGS = ["-w", "-ambiguous-paths,-deprecated,-let-as-axiom", "-Q", ".", "MDR"]
FORBIDDEN = r"\b(Admitted|admit|Axioms?|Parameters?|Conjectures?|give_up|bypass_check|Unset\s+Guard|Unset\s+Positivity|Unset\s+Universe)\b"


def table(name):
    folder = THEOREMS if (THEOREMS / name).exists() else SOURCE
    lines = (folder / name).read_text().splitlines()
    return [line.split("\t") for line in lines if line and not line.startswith("#")]


def stop(message):
    sys.exit(f"error: {message}")


def code(text):
    """The text without its comments."""
    out, depth, i = [], 0, 0
    while i < len(text):
        pair = text[i : i + 2]
        if pair == "(*":
            depth, i = depth + 1, i + 2
        elif pair == "*)" and depth:
            depth, i = depth - 1, i + 2
        else:
            out.append(text[i] if depth == 0 or text[i] == "\n" else "")
            i += 1
    return "".join(out)


def coqc(name, folder=BUILD):
    return subprocess.run(["coqc", *FLAGS, name], cwd=folder, capture_output=True, text=True)


def required(file):
    """The files that this one requires, and those that they require."""
    found, ahead = set(), {SOURCE / file}
    while ahead:
        text = code(ahead.pop().read_text())
        new = {SOURCE / f"{name}.v" for name in re.findall(r"\bMDR\.(\w+)", text)} - found
        found |= new
        ahead |= new
    return sorted(found)


def build(files):
    """Compile what is out of date, two files at a time, in the order of what they require."""
    needs = {f.stem: set(re.findall(r"\bMDR\.(\w+)", code(f.read_text()))) for f in files}
    stale, done = set(), set()
    BUILD.mkdir(parents=True, exist_ok=True)
    for f in files:
        copy = BUILD / f.name
        fresh = copy.exists() and copy.read_bytes() == f.read_bytes() and copy.with_suffix(".vo").exists()
        if not fresh:
            shutil.copyfile(f, copy)
            copy.with_suffix(".vo").unlink(missing_ok=True)
            stale.add(f.stem)
    while more := {f for f in needs if f not in stale and needs[f] & stale}:
        stale |= more
    done = set(needs) - stale
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        running = {}
        while len(done) < len(needs):
            for f in sorted(needs):
                if f not in done and f not in running.values() and needs[f] <= done:
                    running[pool.submit(coqc, f"{f}.v")] = f
            if not running:
                stop(f"the files require each other in a circle: {sorted(set(needs) - done)}")
            ended, _ = concurrent.futures.wait(running, return_when=concurrent.futures.FIRST_COMPLETED)
            for job in ended:
                f, answer = running.pop(job), job.result()
                if answer.returncode:
                    (BUILD / f"{f}.vo").unlink(missing_ok=True)
                    stop(f"Coq refuses {f}.v\n{answer.stdout}{answer.stderr}")
                done.add(f)


def assumptions(theorems, files):
    """Theorem -> names of the axioms that it rests on, asked of Coq in two halves at a time."""
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        halves = pool.map(lambda half: rest_on(theorems[half::2], files, f"Assumptions{half}"), range(min(2, len(theorems))))
        return {name: axioms for half in halves for name, axioms in half.items()}


def rest_together(names, files, stem):
    """The axioms that theorems or lemmas rest on together."""
    asked = f"Require Import {' '.join(f'MDR.{file}' for file in files)}.\n"
    asked += f"Definition all := ({', '.join(names)}).\nPrint Assumptions all.\n"
    return {match[1] for match in re.finditer(r"^([A-Za-z][\w.]*)(?: :|$)", answered(asked, stem), re.M)}


def answered(asked, stem):
    """What Coq prints to a text that asks about theorems and lemmas."""
    (BUILD / f"{stem}.v").write_text(asked)
    answer = coqc(f"{stem}.v")
    if answer.returncode:
        stop(f"a theorem of theorems.tsv or a lemma of Steps.v or StepTheorems.v is not there\n{answer.stderr}")
    return answer.stdout


def rest_on(theorems, files, stem):
    lines = ["Require Import " + " ".join(f"MDR.{f.stem}" for f in files) + "."]
    for _, name, file, _ in theorems:
        lines.append(f'Goal True. idtac "== {name}". Abort.\nPrint Assumptions MDR.{pathlib.Path(file).stem}.{name}.')
    found, current = {}, set()
    for line in answered("\n".join(lines) + "\n", stem).splitlines():
        if line.startswith("== "):
            current = found.setdefault(line[3:], set())
        elif match := re.match(r"([A-Za-z][\w.]*)( :|$)", line):
            current.add(match[1])
    return found


def found_assumptions(theorems, lemmas, files, each):
    """Theorem, or `steps`, -> the axioms that it rests on: by itself for `each`, and for theorems that may rest on more than others;
    else those of all others together, which takes a hundredth of the time."""
    may_more = {name for _, names, _ in table("assumptions.txt") for name in names.split()}
    alone = [row for row in theorems if each or row[1] in may_more]
    found = assumptions(alone, files)
    others = [row for row in theorems if row not in alone]
    if others:
        names = [f"MDR.{pathlib.Path(file).stem}.{name}" for _, name, file, _ in others]
        together = rest_together(names, [f.stem for f in files], "AssumptionsTogether")
        found |= {name: together for _, name, _, _ in others}
    found["steps"] = rest_together(lemmas, ["Steps", "StepTheorems"], "AssumptionsOfSteps")
    return found


def stated_as(*verdicts):
    """The names of the statements of Statements.v with one of these verdicts."""
    return set(re.findall(rf"^\(\* (?:{'|'.join(verdicts)}) \*\)\nDefinition (\w+)", (SOURCE / "Statements.v").read_text(), re.M))


def proved_in(file):
    """The names of the statements that a file proves, in its order."""
    return re.findall(r"^Lemma prove_(\w+) : \1\.$", code((SOURCE / file).read_text()), re.M)


def steps():
    """The lemmas that prove statements of Statements.v: in Steps.v those that normal forms prove, but for what is left out, and
    in StepTheorems.v those that have a theorem."""
    stated, proved = stated_as("proved", "definition"), proved_in("Steps.v")
    left_out = {name for name, _ in table("left_out.tsv")}
    if stated != set(proved) | left_out or left_out & set(proved):
        stop(f"neither proved in Steps.v nor left out, or both: {sorted(stated ^ (set(proved) | left_out))}")
    by_theorem, named = proved_in("StepTheorems.v"), {name for name, _ in table("by_theorem.tsv")}
    if not set(by_theorem) == named == stated_as("theorem"):
        stop(f"by_theorem.tsv, StepTheorems.v and Statements.v differ: {sorted(set(by_theorem) ^ named | named ^ stated_as('theorem'))}")
    return [f"prove_{name}" for name in [*proved, *by_theorem]]


def step_mutant(text, old, new):
    """Statements.v with a change, reduced to the changed step and its proof: text, and where both begin."""
    begin = text.rindex("Definition step_", 0, text.index(old))
    changed = text[begin : text.index(".\n", text.index(old)) + 2].replace(old, new)
    name = re.match(r"Definition (\w+)", changed)[1]
    proofs = (SOURCE / "Steps.v").read_text()
    head = proofs[: proofs.index("\nLemma ")]
    lemma = re.search(rf"^Lemma prove_{name} .*?Qed\.\n", proofs, re.M | re.S)[0]
    return f"{head}\n{changed}{lemma}"


def proofs_begin(text, changes):
    """Where the proofs of the statements begin that hold these texts."""
    return {text.index("Proof.", text.index(old)) for old in changes}


def only_with(text, begins):
    """The text with the proofs alone that begin at these places: other statements are taken as they are. Its lines stay where they are."""
    admit = lambda proof: proof[0] if proof.start() in begins else "Admitted." + "\n" * proof[0].count("\n")
    return re.sub(r"\bProof\..*?\bQed\.", admit, text, flags=re.S)


def accepted(text, file, stem):
    """What Coq says to a text that stands for a file: none when it is accepted, and always the same answer to the same text."""
    key = hashlib.sha1((text + "".join(code(f.read_text()) for f in required(file))).encode()).hexdigest()
    answered = BUILD / f"{stem}_{key}.txt"
    if answered.exists():
        return answered.read_text() or None
    path = BUILD / f"{stem}_{key}.v"
    path.write_text(text)
    answer = coqc(path.name)
    for left in BUILD.glob(f"*{path.stem}*"):
        left.unlink()
    answered.write_text("" if answer.returncode == 0 else answer.stderr)
    return None if answer.returncode == 0 else answer.stderr


def may_be_taken(file, changes):
    """Whether Coq accepts a file without the proofs of other statements than these: it may not where a lemma of a section uses a
    hypothesis in its proof only."""
    text = code((SOURCE / file).read_text())
    return accepted(only_with(text, proofs_begin(text, changes)), file, "unchanged") is None


def mutant(is_short, file, old, new):
    """None when Coq refuses the mutated statement, otherwise what is wrong. If the file is short, other statements are taken as they are."""
    if file == "Statements.v":
        text, file = step_mutant((SOURCE / file).read_text(), old, old), "Steps.v"
    else:
        text = code((SOURCE / file).read_text())
        text = only_with(text, proofs_begin(text, [old])) if is_short else text
    refused = accepted(text.replace(old, new), file, "mutant")
    if refused is None:
        return f"{file}: Coq accepts {new!r} in place of {old!r}"
    begin = text.index("Proof.", text.index(old))
    end = text.index("Qed.", begin)
    first, last = (text[:at].count("\n") + 1 for at in (begin, end))
    shift = old.count("\n") - new.count("\n")
    line = int(re.search(r"line (\d+), characters [-\d]+:\s+Error", refused)[1]) + shift
    if not first <= line <= last:
        return f"{file}: {new!r} fails at line {line}, not in the proof of its statement\n{refused}"
    return None


def main():
    files = sorted(SOURCE.glob("*.v"))
    theorems = table("theorems.tsv")
    version = subprocess.run(["coqc", "--print-version"], capture_output=True, text=True).stdout.split()[0]
    if not version.startswith("8.16"):
        print(f"note: Coq {version}; the proofs are written for 8.16")
    for f in files:
        if found := re.search(FORBIDDEN, code(f.read_text())):
            stop(f"{f}: {found[0]}")
    build(files)

    stated = {
        (name, f.name) for f in files for name in re.findall(r"^(?:Theorem|Corollary)\s+(\w+)", code(f.read_text()), re.M)
    }
    named = {(name, file) for _, name, file, _ in theorems}
    if named - stated:
        stop(f"theorems.tsv names what is no theorem: {sorted(named - stated)}")
    if stated - named:
        stop(f"theorems.tsv lacks {sorted(stated - named)}")

    lemmas = steps()
    allowed = table("assumptions.txt")
    found = found_assumptions(theorems, lemmas, files, "--each" in sys.argv[1:])
    width = max(len(entry) for entry, *_ in theorems), max(len(name) for _, name, *_ in theorems)
    for entry, name, _, _ in [*theorems, ("all", "steps", "Steps.v", "")]:
        groups = {}
        for axiom in found[name]:
            row = next((r for r in allowed if re.fullmatch(r[0], axiom) and (r[1] == "all" or name in r[1].split())), None)
            if row is None:
                stop(f"{name} rests on {axiom}, which assumptions.txt does not allow it")
            groups[row[2]] = None
        print(f"{entry:<{width[0]}}  {name:<{width[1]}}  {', '.join(sorted(groups)) or 'nothing'}", flush=True)

    mutants = table("mutants.tsv")
    if missing := {file for _, file in named} - {file for file, *_ in mutants}:
        stop(f"mutants.tsv has none for {sorted(missing)}")
    for file, old, _ in mutants:
        if (times := code((SOURCE / file).read_text()).count(old)) != 1:
            stop(f"mutants.tsv: {old!r} occurs {times} times in {file}")
    changes = {file: [old for other, old, _ in mutants if other == file] for file, *_ in mutants if file != "Statements.v"}
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        short = dict(zip(changes, pool.map(may_be_taken, changes, changes.values())))
        wrong = [answer for answer in pool.map(lambda row: mutant(short.get(row[0]), *row), mutants) if answer]
    if wrong:
        stop("\n".join(wrong))
    print(f"{len(named)} theorems and {len(lemmas)} steps in {len(files)} files checked by Coq {version}; {len(mutants)} mutated statements refused")


if __name__ == "__main__":
    main()
