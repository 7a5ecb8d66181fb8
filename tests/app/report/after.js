// After the page: a script drives it, and its result, or the complaints, stand in <pre id="result">.
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
