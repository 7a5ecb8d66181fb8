// Runs after the page: a script drives the page; its result, or the errors, go to <pre id="result">.
window.addEventListener("load", function () {
  var result = "";
  try {
    /* SCRIPT */
  } catch (error) { complaints.push(String(error)); }
  var pre = document.createElement("pre");
  pre.id = "result";
  pre.textContent = complaints.length ? "COMPLAINTS " + complaints.join("; ") : result;
  document.body.appendChild(pre);
});
