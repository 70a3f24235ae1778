//! docs/json.md from docs/schema.json.

use std::fmt::Write as _;

use serde_json::Value;

/// What stands before the tables.
const HEAD: &str = "# The JSON of `analyze`

`assur analyze SCENE --format json` prints one object on one line. [schema.json](schema.json) describes it for programs, as a JSON Schema
(2020-12); this page is made of it.

```sh
assur analyze fixtures/four-bar.toml --format json | jq '.positions[0].points.B.pf0'
```

";

/// The whole page.
pub(super) fn of(schema: &Value) -> String {
    let mut page = HEAD.to_owned();
    let _ = writeln!(page, "{}\n", text(schema, "description"));
    page += "`NAME` stands for a name of the scene, or for what the column beside it says; `[]` for the items of a list.\n\n## Results\n\n";
    table(schema, &mut page);
    for (name, title) in
        [("position", "Position"), ("sample", "Sample"), ("dynamics", "Dynamics"), ("plan", "Plan")]
    {
        let part = &schema["$defs"][name];
        let _ = write!(page, "\n## {title}\n\n{}\n\n", text(part, "description"));
        table(part, &mut page);
    }
    page +=
        "\n## What positions and samples have in common\n\n| key | unit | meaning |\n| --- | --- | --- |\n";
    for (name, part) in schema["$defs"].as_object().into_iter().flatten() {
        if !["position", "sample", "dynamics", "plan", "reaction"].contains(&name.as_str()) {
            row(name, part, &mut page);
            below(name, part, &mut page);
        }
    }
    page += "\n## Reaction\n\n";
    let reaction = &schema["$defs"]["reaction"];
    let _ =
        write!(page, "{}\n\n| key | unit | meaning |\n| --- | --- | --- |\n", text(reaction, "description"));
    below("", reaction, &mut page);
    page
}

fn table(part: &Value, page: &mut String) {
    *page += "| key | unit | meaning |\n| --- | --- | --- |\n";
    below("", part, page);
}

fn text<'a>(part: &'a Value, key: &str) -> &'a str {
    part[key].as_str().unwrap_or_default()
}

/// Whether a part may be null.
fn is_nullable(part: &Value) -> bool {
    part["type"].as_array().is_some_and(|kinds| kinds.iter().any(|kind| kind == "null"))
}

fn row(path: &str, part: &Value, page: &mut String) {
    let unit = text(part, "unit").trim_start_matches(" or ");
    let mut meaning = text(part, "description").to_owned();
    if let Some(name) = part["$ref"].as_str().and_then(|reference| reference.strip_prefix("#/$defs/")) {
        let section = if ["position", "sample", "dynamics", "plan", "reaction"].contains(&name) {
            name
        } else {
            "what-positions-and-samples-have-in-common"
        };
        let _ = write!(meaning, "{}See [{name}](#{section}).", if meaning.is_empty() { "" } else { " " });
    }
    if let Some(choices) = part["enum"].as_array().filter(|_| !meaning.contains('`')) {
        let choices: Vec<_> =
            choices.iter().filter_map(Value::as_str).map(|one| format!("`{one}`")).collect();
        let _ = write!(meaning, " {}.", choices.join(", "));
    }
    if is_nullable(part) && !meaning.contains("null") {
        meaning += " Null where it is not determined.";
    }
    let _ = writeln!(page, "| `{path}` | {unit} | {meaning} |");
}

/// The rows of what is below a part.
fn below(path: &str, part: &Value, page: &mut String) {
    let dot = if path.is_empty() { "" } else { "." };
    for (key, part) in part["properties"].as_object().into_iter().flatten() {
        let path = format!("{path}{dot}{key}");
        row(&path, part, page);
        below(&path, part, page);
    }
    if part["additionalProperties"].is_object() {
        let name = text(&part["propertyNames"], "title").to_uppercase();
        let (path, part) = (format!("{path}{dot}{name}"), &part["additionalProperties"]);
        row(&path, part, page);
        below(&path, part, page);
    }
    let item = &part["items"];
    if item["description"].is_string() || item["$ref"].is_string() {
        row(&format!("{path}[]"), item, page);
    }
    if item.is_object() {
        below(&format!("{path}[]"), item, page);
    }
    for alternative in part["anyOf"].as_array().into_iter().flatten() {
        if !text(alternative, "description").is_empty() && alternative["type"] != "object" {
            row(path, alternative, page);
        }
        below(path, alternative, page);
    }
}
