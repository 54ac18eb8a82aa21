"""The commands of a block: whether their verbs, options and files exist."""
import functools
import re
import shlex
import subprocess


def commands_of(block):
    """The commands of a code block: behind `$ ` where it shows what they print, else lines that begin with one."""
    text = "\n".join(block.lines)
    prompts = any(line.startswith("$ ") for line in block.lines)
    joined = re.sub(r"\\\n\s*", "", text)
    found = []
    for line in joined.split("\n"):
        if prompts and not line.startswith("$ "):
            continue
        found.append(line[2:] if prompts else line)
    return found


def riffle_calls(line):
    """The calls of riffle in a command line, as lists of words: (verb, options)."""
    try:
        words = shlex.split(re.sub(r"\s{2,}(#?\s*[\w(].*)$", "", line) if " riffle" not in line[1:] else line, comments=True)
    except ValueError:
        return []
    calls, current = [], None
    for word in words:
        if word == "riffle" or word.endswith("/riffle"):
            current = []
            calls.append(current)
        elif word in {"|", ">", "&&", ";", "||", "<", "&"}:
            current = None
        elif current is not None:
            current.append(word)
    return [call for call in calls if call]


@functools.lru_cache(maxsize=None)
def help_of(program, verb):
    result = subprocess.run([program, verb, "--help"], capture_output=True, text=True, timeout=60)
    return result.stdout if result.returncode == 0 else None


@functools.lru_cache(maxsize=None)
def verbs_of(program):
    text = subprocess.run([program, "--help"], capture_output=True, text=True, timeout=60).stdout
    return set(re.findall(r"^  (\w+) ", text.partition("Subcommands:")[2].partition("Examples:")[0], re.M))


def faults_of(line, program):
    """What is wrong with the riffle calls of a command line."""
    faults = []
    for call in riffle_calls(line):
        verb = call[0]
        if verb.startswith("-") or not re.fullmatch(r"[a-z]+", verb):
            continue
        if verb not in verbs_of(program):
            faults.append(f"`riffle {verb}`: there is no such verb")
            continue
        known = set(re.findall(r"(?<![\w-])(--?[a-zA-Z][\w-]*)", help_of(program, verb))) | {"--help", "-h"}
        for word in call[1:]:
            option = word.partition("=")[0]
            if re.fullmatch(r"--?[a-zA-Z][\w-]*", option) and option not in known:
                faults.append(f"`riffle {verb}` has no option {option}")
    return faults
