// `npm run doc`: the documentation of the Rust source, in `target/doc/umbilic`.

import { buildDocumentation } from "./documentation.js";

buildDocumentation();
